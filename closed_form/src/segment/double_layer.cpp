// SPDX-License-Identifier: MIT
#include "cageproof/closed_form/segment/double_layer.h"

#include "engine/register_form.h"

namespace cageproof::closed_form::segment {
namespace {

const RegisterForm<DoubleLayer> register_double_layer{"segment.double_layer"};

}  // namespace
}  // namespace cageproof::closed_form::segment
