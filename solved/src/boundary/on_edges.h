// SPDX-License-Identifier: MIT
// The edges of a refined polygon that a point is on, and how far along.
#pragma once

#include "boundary_layers.h"
#include "touching.h"

#include <cmath>
#include <vector>

namespace cageproof::solved {

/// Empty for a point off the polygon. \param elements the polygon's edges
template <Scalar R>
std::vector<OnEdge<R>> on_edges(const RefinedPolygon& polygon, const CageElements& elements, const Vec3<R>& point) {
  std::vector<OnEdge<R>> found;
  for (const Touching& touch : touching(elements, point)) {
    const auto line = polygon.line<R>(touch.element);
    const int from = polygon.seer(touch.element, 0);
    R steps = line.direction.dot(polygon.seen_from<R>(from, {point}) - polygon.along<R>(touch.element, R(0), from)) /
              line.piece;
    using std::abs, std::round;
    // Rounding may keep a node of the refined polygon from being a whole number.
    const R whole = round(steps);
    if (abs(steps - whole) <= 16 * polygon.pieces_an_edge() * unit_roundoff<R>()) steps = whole;
    found.push_back({touch.element, steps});
  }
  return found;
}

}  // namespace cageproof::solved
