// SPDX-License-Identifier: MIT
#include "register_form.h"

namespace cageproof::closed_form {
namespace {

const RegisterForm<BiharmonicSingleLayer> registered{"triangle.biharmonic_single_layer"};

}  // namespace
}  // namespace cageproof::closed_form
