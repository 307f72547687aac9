// SPDX-License-Identifier: MIT
#include "register_form.h"

namespace cageproof::closed_form {
namespace {

const RegisterForm<KelvinTraction> registered{"triangle.kelvin_traction"};

}  // namespace
}  // namespace cageproof::closed_form
