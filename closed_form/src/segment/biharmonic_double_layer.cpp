// SPDX-License-Identifier: MIT
#include "cageproof/closed_form/segment/biharmonic_double_layer.h"

#include "engine/register_form.h"

namespace cageproof::closed_form::segment {
namespace {

const RegisterForm<BiharmonicDoubleLayer> register_biharmonic_double_layer{"segment.biharmonic_double_layer"};

}  // namespace
}  // namespace cageproof::closed_form::segment
