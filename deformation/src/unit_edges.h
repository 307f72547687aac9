// SPDX-License-Identifier: MIT
// A triangle's edges, in a unit of their own.
#pragma once

#include "cageproof/core/cage/cage_elements.h"
#include "cageproof/core/numbers/linear.h"

#include <algorithm>
#include <array>

namespace cageproof::deformation {

/// Edges of a triangle from a corner, over their largest number.
template <Scalar R>
struct UnitEdges {
  std::array<Vec3<R>, 2> edges;
  R unit;

  template <class Vertices>
  UnitEdges(const CageElements& rest, const Vertices& vertices, std::size_t element, int corner) {
    const auto corners = rest.vertices_of(element);
    const auto at = [&](int k) { return convert<R>(vertices[corners[(corner + k) % 3]]); };
    edges = {Vec3<R>(at(1) - at(0)), Vec3<R>(at(2) - at(0))};
    unit = std::max<R>(edges[0].cwiseAbs().maxCoeff(), edges[1].cwiseAbs().maxCoeff());
    if (unit > 0)
      for (Vec3<R>& edge : edges) edge /= unit;
  }
};

/// The corner between the two shorter edges at rest, where the angle is widest and least cancels.
inline int widest_corner(const CageElements& rest, std::size_t element) {
  const auto corners = rest.vertices_of(element);
  int widest = 0;
  double longest = -1;
  for (int k = 0; k < 3; ++k) {
    const double across = (rest.vertices()[corners[(k + 2) % 3]] - rest.vertices()[corners[(k + 1) % 3]]).stableNorm();
    if (across > longest) longest = across, widest = k;
  }
  return widest;
}

}  // namespace cageproof::deformation
