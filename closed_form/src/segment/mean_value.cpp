// SPDX-License-Identifier: MIT
#include "cageproof/closed_form/segment/mean_value.h"

#include "engine/register_form.h"

namespace cageproof::closed_form::segment {
namespace {

const RegisterForm<MeanValue> register_mean_value{"segment.mean_value"};

}  // namespace
}  // namespace cageproof::closed_form::segment
