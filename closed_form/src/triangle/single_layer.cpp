// SPDX-License-Identifier: MIT
#include "cageproof/closed_form/triangle/single_layer.h"

#include "engine/register_form.h"

namespace cageproof::closed_form::triangle {
namespace {

const RegisterForm<SingleLayer> register_single_layer{"triangle.single_layer"};

}  // namespace
}  // namespace cageproof::closed_form::triangle
