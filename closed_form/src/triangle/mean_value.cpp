// SPDX-License-Identifier: MIT
#include "cageproof/closed_form/triangle/mean_value.h"

#include "engine/register_form.h"

namespace cageproof::closed_form::triangle {
namespace {

const RegisterForm<MeanValue> register_mean_value{"triangle.mean_value"};

}  // namespace
}  // namespace cageproof::closed_form::triangle
