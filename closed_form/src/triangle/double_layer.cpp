// SPDX-License-Identifier: MIT
#include "register_form.h"

namespace cageproof::closed_form {
namespace {

const RegisterForm<DoubleLayer> registered{"triangle.double_layer"};

}  // namespace
}  // namespace cageproof::closed_form
