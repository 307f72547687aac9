// SPDX-License-Identifier: MIT
#include "register_form.h"

namespace cageproof::closed_form {
namespace {

const RegisterForm<MeanValue> registered{"triangle.mean_value"};

}  // namespace
}  // namespace cageproof::closed_form
