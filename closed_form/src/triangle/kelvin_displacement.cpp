// SPDX-License-Identifier: MIT
#include "register_form.h"

namespace cageproof::closed_form {
namespace {

const RegisterForm<KelvinDisplacement> registered{"triangle.kelvin_displacement"};

}  // namespace
}  // namespace cageproof::closed_form
