// SPDX-License-Identifier: MIT
// Errors on the way from far away to the element.
#pragma once

#include "defects/study.h"

namespace cageproof::judge {

/// Whether errors rise smoothly from nothing, some sizes away, to 1e-8 or more next to the element, as those of
/// a fixed quadrature do. A threshold makes a step, and errors of a projection fall on the way.
bool errors_rise_towards(const Study& study, int order, std::uint64_t seed);

}  // namespace cageproof::judge
