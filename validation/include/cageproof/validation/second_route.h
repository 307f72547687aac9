// SPDX-License-Identifier: MIT
#pragma once

#include "cageproof/core/coordinates/coordinates.h"

#include <functional>
#include <vector>

namespace cageproof::validation {

/// How far a kind's coordinates of a point, block by block, are from those of its second route: relative, norm-wise, of
/// the worst block. NaN where one of the two has none.
using SecondRoute = std::function<double(const Vec3<double>& point, const std::vector<std::vector<Mp100>>& blocks)>;

/// The second route of a kind that is no sum over elements, on a cage, which must outlive it. Safe from any thread.
/// \return an empty function where there is none
SecondRoute second_route_of(const CoordinateKind& kind, const Cage& cage);

}  // namespace cageproof::validation
