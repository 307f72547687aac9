// SPDX-License-Identifier: MIT
#include "cageproof/closed_form/segment/winding_angle.h"

#include "engine/register_form.h"

namespace cageproof::closed_form::segment {
namespace {

const RegisterForm<WindingAngle> register_winding_angle{"segment.winding_angle"};

}  // namespace
}  // namespace cageproof::closed_form::segment
