// SPDX-License-Identifier: MIT
#include "cageproof/closed_form/segment/polyharmonic_double_layer.h"

#include "engine/register_form.h"

namespace cageproof::closed_form::segment {
namespace {

const RegisterForm<PolyharmonicDoubleLayer> register_polyharmonic_double_layer{"segment.polyharmonic_double_layer"};

}  // namespace
}  // namespace cageproof::closed_form::segment
