// SPDX-License-Identifier: MIT
#include "register_form.h"

namespace cageproof::closed_form {
namespace {

const RegisterForm<SolidAngle> registered{"triangle.solid_angle"};

}  // namespace
}  // namespace cageproof::closed_form
