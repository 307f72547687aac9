// SPDX-License-Identifier: MIT
#include "cageproof/closed_form/segment/single_layer.h"

#include "engine/register_form.h"

namespace cageproof::closed_form::segment {
namespace {

const RegisterForm<SingleLayer> register_single_layer{"segment.single_layer"};

}  // namespace
}  // namespace cageproof::closed_form::segment
