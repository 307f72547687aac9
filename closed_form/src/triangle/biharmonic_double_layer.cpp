// SPDX-License-Identifier: MIT
#include "cageproof/closed_form/triangle/biharmonic_double_layer.h"

#include "engine/register_form.h"

namespace cageproof::closed_form::triangle {
namespace {

const RegisterForm<BiharmonicDoubleLayer> register_biharmonic_double_layer{"triangle.biharmonic_double_layer"};

}  // namespace
}  // namespace cageproof::closed_form::triangle
