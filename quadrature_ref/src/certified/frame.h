// SPDX-License-Identifier: MIT
// A triangle as its point sees it, in balls: an orthonormal frame in its plane, edges as lines past the point, hat
// functions.
#pragma once

#include "ball.h"

#include "cageproof/core/catalogue/evaluation.h"

#include <array>
#include <optional>

namespace cageproof::quadrature_ref::certified {

/// An edge's line about the projection of the point onto the plane, arc length tau from the foot of the perpendicular.
struct EdgeFrame {
  Real height;          ///< signed distance of the line from the projection, positive if that lies to its inner side
  bool passes = false;  ///< height is exactly zero
  Real distance;        ///< of the line from the point itself; its square is height^2 + d^2
  Real first, last;     ///< tau at the corners
  std::array<Real, 2> along;    ///< unit vector of the edge, in the plane's axes
  std::array<Real, 2> outward;  ///< unit normal of the edge, in the plane
};

/// x = xi - eta of the triangle's points in the frame: (y1, y2, d), y the same for all frames and d constant.
struct Frame {
  std::array<std::array<Real, 3>, 3> axes;  ///< two in the plane, then the outward unit normal; right-handed
  Real height;                              ///< d = x . normal
  bool in_plane = false;                    ///< d is exactly zero
  bool on_triangle = false;                 ///< the point lies on the triangle, its border included
  std::array<EdgeFrame, 3> edges;           ///< from corner k to corner k + 1
  std::array<std::array<Real, 3>, 3> hat;   ///< hat function of corner k: hat[k][0] + hat[k][1] y1 + hat[k][2] y2
};

/// The frame at working_bits, with exact signs. Nothing for a triangle without area, an input that is not finite, or
/// one whose coordinates spread over more than 2^20000.
template <Scalar R>
std::optional<Frame> frame_of(const Query<R>& query);

}  // namespace cageproof::quadrature_ref::certified
