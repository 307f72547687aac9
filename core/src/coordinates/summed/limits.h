// SPDX-License-Identifier: MIT
// Limits of sums from inside, at points on the cage.
#pragma once

#include "summands.h"

namespace cageproof {

// As HasLimits::fill_limits.
void put_limits(const Summands& sum, std::span<const Touching> places, int order,
                std::span<CoordinateTable<double>> tables);
void put_limits(const Summands& sum, std::span<const Touching> places, int order,
                std::span<CoordinateTable<Mp50>> tables);

}  // namespace cageproof
