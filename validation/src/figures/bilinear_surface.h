// SPDX-License-Identifier: MIT
// Bilinear quads to be drawn, and their projections.
#pragma once

#include "cageproof/core/numbers/vector.h"
#include "cageproof/core/results/run_result.h"

namespace cageproof::validation {

/// The point of a quad at parameters in [0, 1] ([T18] Eq 2).
Vec3<double> bilinear_point(const Quad<double>& quad, double u, double v);

/// The quad in steps x steps faces, whose corners are at equal parameters.
MeshField bilinear_surface(const Quad<double>& quad, int steps);

/// One of the four projections of [T18] Definition 1.
struct LeastConvex {
  int corner;               ///< along the normal of the triangle of this corner and its neighbours
  double sine;              ///< the least, over corners, of the sine of the turn there; positive where convex
  Quad<double> projection;  ///< in the plane, third coordinates zero
};

/// The one of the four that is the least convex, whose least sine is the smallest. In double: to draw, not to decide.
/// \pre no three successive corners lie on a line, and no projection has an edge of no length
LeastConvex least_convex_projection(const Quad<double>& quad);

}  // namespace cageproof::validation
