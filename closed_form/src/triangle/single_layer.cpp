// SPDX-License-Identifier: MIT
#include "register_form.h"

namespace cageproof::closed_form {
namespace {

const RegisterForm<SingleLayer> registered{"triangle.single_layer"};

}  // namespace
}  // namespace cageproof::closed_form
