// SPDX-License-Identifier: MIT
#include "cageproof/closed_form/segment/polyharmonic_single_layer.h"

#include "engine/register_form.h"

namespace cageproof::closed_form::segment {
namespace {

const RegisterForm<PolyharmonicSingleLayer> register_polyharmonic_single_layer{"segment.polyharmonic_single_layer"};

}  // namespace
}  // namespace cageproof::closed_form::segment
