// SPDX-License-Identifier: MIT
#include "cageproof/closed_form/segment/kelvin_traction.h"

#include "engine/register_form.h"

namespace cageproof::closed_form::segment {
namespace {

const RegisterForm<KelvinTraction> register_kelvin_traction{"segment.kelvin_traction"};

}  // namespace
}  // namespace cageproof::closed_form::segment
