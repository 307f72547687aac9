// SPDX-License-Identifier: MIT
#include "cageproof/closed_form/segment/biharmonic_single_layer.h"

#include "engine/register_form.h"

namespace cageproof::closed_form::segment {
namespace {

const RegisterForm<BiharmonicSingleLayer> register_biharmonic_single_layer{"segment.biharmonic_single_layer"};

}  // namespace
}  // namespace cageproof::closed_form::segment
