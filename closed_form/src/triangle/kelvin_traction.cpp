// SPDX-License-Identifier: MIT
#include "cageproof/closed_form/triangle/kelvin_traction.h"

#include "engine/register_form.h"

namespace cageproof::closed_form::triangle {
namespace {

const RegisterForm<KelvinTraction> register_kelvin_traction{"triangle.kelvin_traction"};

}  // namespace
}  // namespace cageproof::closed_form::triangle
