// SPDX-License-Identifier: MIT
#include "cageproof/deformation/moved_inside.h"

#include "cageproof/core/geometry/box.h"
#include "cageproof/core/parallel.h"
#include "cageproof/deformation/nearest_element.h"

#include <algorithm>
#include <limits>

namespace cageproof::deformation {
MovedInside moved_inside(const CageElements& elements, const std::vector<Vec3<double>>& points, double distance,
                         int jobs) {
  const Inside inside(elements);
  const NearestElements all(elements);
  const auto [low, high] = box_of(elements.vertices());
  const double rounding =
      std::numeric_limits<double>::epsilon() * std::max(low.cwiseAbs().maxCoeff(), high.cwiseAbs().maxCoeff());
  MovedInside found{points};
  std::vector<double> ways(points.size(), 0);
  // The place itself, then twice as far in each time, by whichever way leads inside: at an edge or a vertex that is one
  // between the normals of the elements there, or along the nearest one.
  const auto move = [&](std::size_t p) {
    const NearestElement nearest = all.of(points[p]);
    if (!(nearest.distance <= distance)) return;
    const std::vector<Vec3<double>> ways_in = all.inwards_at(nearest, 64 * rounding);
    for (double step = 0; step <= distance; step = std::max(rounding, 2 * step))
      for (const Vec3<double>& way : ways_in) {
        const Vec3<double> place = nearest.place + step * way;
        if (!inside.holds(place)) continue;
        found.points[p] = place;
        ways[p] = (place - points[p]).stableNorm();
        return;
      }
  };
  for_each_parallel(points.size(), jobs, [&](std::size_t p) {
    if (!inside.holds(points[p])) move(p);
  });
  for (const double way : ways) {
    found.farthest = std::max(found.farthest, way);
    if (way > 0) ++found.count;
  }
  return found;
}

}  // namespace cageproof::deformation
