// SPDX-License-Identifier: MIT
#include "cageproof/closed_form/segment/affine_single_layer.h"

#include "engine/register_form.h"

namespace cageproof::closed_form::segment {
namespace {

const RegisterForm<AffineSingleLayer> register_affine_single_layer{"segment.affine_single_layer"};

}  // namespace
}  // namespace cageproof::closed_form::segment
