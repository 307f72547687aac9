// SPDX-License-Identifier: MIT
// A bilinear quad as its point sees it, exactly, and its lines v = const about the middle of a stretch of v.
#pragma once

#include "../exact_input.h"

namespace cageproof::quadrature_ref::certified {

/// Exact: x = corner - point. Line v runs from starts[0] + v across[0], where u = 0, to starts[1] + v across[1].
struct SeenQuad {
  std::array<Vector, 2> starts;
  std::array<Vector, 2> across;                ///< the sides u = 0 and u = 1
  std::array<std::array<Real, 2>, 2> heights;  ///< N.x at u, v = 0 or 1: [u][v]; bilinear
  bool flat = false;                           ///< N.x is exactly zero all over the quad
};

/// Nothing for a quad whose normals vanish all over it, an input that is not finite, or one whose coordinates spread
/// over more than 2^20000.
template <Scalar R>
std::optional<SeenQuad> seen_quad(const Query<R>& query);

/// A stretch of v, |v - middle| <= half, with the middle's line exactly.
struct QuadStretch {
  Real middle, half;
  std::array<Vector, 2> ends;           ///< of the line v = middle
  std::array<Real, 2> heights, slopes;  ///< N.x at the ends, and its derivative by v
};
QuadStretch stretch_of(const SeenQuad& quad, const Real& middle, const Real& half);

}  // namespace cageproof::quadrature_ref::certified
