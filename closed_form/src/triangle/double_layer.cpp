// SPDX-License-Identifier: MIT
#include "cageproof/closed_form/triangle/double_layer.h"

#include "engine/register_form.h"

namespace cageproof::closed_form::triangle {
namespace {

const RegisterForm<DoubleLayer> register_double_layer{"triangle.double_layer"};

}  // namespace
}  // namespace cageproof::closed_form::triangle
