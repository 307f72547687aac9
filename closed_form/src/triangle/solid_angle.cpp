// SPDX-License-Identifier: MIT
#include "cageproof/closed_form/triangle/solid_angle.h"

#include "engine/register_form.h"

namespace cageproof::closed_form::triangle {
namespace {

const RegisterForm<SolidAngle> register_solid_angle{"triangle.solid_angle"};

}  // namespace
}  // namespace cageproof::closed_form::triangle
