// SPDX-License-Identifier: MIT
// Points on a polygon's edges, dense at their ends.
#pragma once

#include "polygon_frame.h"

#include "dirichlet_solver.h"

namespace cageproof::solved::goursat {

/// A point of the boundary in the frame.
struct FramePoint {
  int edge;
  double from_start, from_end;
};

/// Chebyshev points: at (1 - cos(pi (i + phase)/n))/2 of each edge, i < n. Longer edges get more of them.
/// \param least how many there are at least \param phase in (0, 1)
std::vector<FramePoint> boundary_points(const PolygonFrame& frame, int least, double phase);

/// The same point in the cage's unit.
EdgePoint edge_point(const PolygonFrame& frame, const FramePoint& p);

}  // namespace cageproof::solved::goursat
