// SPDX-License-Identifier: MIT
#include "cageproof/closed_form/segment/kelvin_displacement.h"

#include "engine/register_form.h"

namespace cageproof::closed_form::segment {
namespace {

const RegisterForm<KelvinDisplacement> register_kelvin_displacement{"segment.kelvin_displacement"};

}  // namespace
}  // namespace cageproof::closed_form::segment
