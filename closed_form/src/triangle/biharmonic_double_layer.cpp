// SPDX-License-Identifier: MIT
#include "register_form.h"

namespace cageproof::closed_form {
namespace {

const RegisterForm<BiharmonicDoubleLayer> registered{"triangle.biharmonic_double_layer"};

}  // namespace
}  // namespace cageproof::closed_form
