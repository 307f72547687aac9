// SPDX-License-Identifier: MIT
#include "cageproof/closed_form/triangle/kelvin_displacement.h"

#include "engine/register_form.h"

namespace cageproof::closed_form::triangle {
namespace {

const RegisterForm<KelvinDisplacement> register_kelvin_displacement{"triangle.kelvin_displacement"};

}  // namespace
}  // namespace cageproof::closed_form::triangle
