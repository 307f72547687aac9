// SPDX-License-Identifier: MIT
// Second routes of kinds of coordinates that are no sums over elements: from their definitions, in 100 digits, with
// nothing of the first route but number types and, where the definition takes them, another kind's coordinates.
#pragma once

#include "cageproof/core/coordinates/coordinates.h"

#include <memory>
#include <vector>

namespace cageproof::second_routes {

/// All coordinates of a point.
using Blocks = std::vector<std::vector<Mp100>>;

/// A kind's route on a cage. Safe from any thread.
class CageRoute {
 public:
  virtual ~CageRoute() = default;
  /// The scalar in which the first route is compared: fewer digits where what the definition takes as given is slow.
  virtual ScalarKind compared_in() const = 0;
  /// How far the first route's coordinates of a point off the cage, block by block, are from this route's: relative,
  /// norm-wise, of the worst block; or from the conditions of the definition, where that is more. NaN where one of them
  /// has none.
  virtual double error_at(const Vec3<double>& point, const Blocks& first) const = 0;
};

/// Norm-wise over all entries, relative to the expected ones' norm, or to `least` if that is larger. NaN where an entry
/// is.
double relative_distance(std::span<const Mp100> found, std::span<const Mp100> expected, double least = 0);

/// The route of a kind on a cage. Null for kinds that have none, and on cages with more than 50 faces, where integrals
/// in 100 digits take half a second per point; for kinds that solve equations, on cages with more than eight edges.
/// \param cage outlives the route
std::shared_ptr<const CageRoute> cage_route(const CoordinateKind& kind, const Cage& cage);

}  // namespace cageproof::second_routes
