// SPDX-License-Identifier: MIT
// Somebody else's implementation of a formula, as an evaluation like any other.
#pragma once

#include "cageproof/core/catalogue/evaluation.h"

#include <functional>
#include <string_view>

namespace cageproof::judge {

/// Registers somebody else's implementation for the rest of the process, with Role::Foreign: whoever names evaluations
/// (verify, bench, hunt, replay) finds it as `name` of `formula`. The default run measures it, because its family is
/// standard.
/// \param formula of the catalogue
/// \param name what the user calls it; no evaluation of the formula has that name
/// \param max_order highest derivative with respect to the point that it gives
/// \param fill sets its functions, for the scalars it has
/// \throws InputError where the catalogue has no such formula, or the formula an evaluation of that name
void add_foreign(std::string_view formula, std::string_view name, int max_order, std::function<void(Evaluation&)> fill);

}  // namespace cageproof::judge
