// SPDX-License-Identifier: MIT
// Second routes of kinds of coordinates that are no sums over elements: from their definitions, in 100 digits, with
// nothing of the first route but number types and, where the definition takes them, another kind's coordinates.
#pragma once

#include "cageproof/core/coordinates.h"

#include <functional>
#include <vector>

namespace cageproof::second_routes {

/// A kind's coordinates of a point off the cage, one a vertex; NaN where there are none. Safe from any thread.
using CageRoute = std::function<std::vector<Mp100>(const Vec3<double>& point)>;

/// The route of a kind on a cage; empty for kinds that have none. \param cage outlives the route
CageRoute cage_route(const CoordinateKind& kind, const Cage& cage);

}  // namespace cageproof::second_routes
