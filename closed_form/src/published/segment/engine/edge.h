// SPDX-License-Identifier: MIT
// An edge of a polygon seen from a point in the notation of [W12] Appendix A. As printed: nothing is stabilised.
#pragma once

#include "cageproof/closed_form/published/misprint.h"
#include "cageproof/core/geometry/element.h"

#include <cmath>

namespace cageproof::closed_form::published {

/// The point in the edge's frame, T_i, and the numbers that all basis functions use, in the caller's units of length.
template <Scalar R>
struct PlaneEdge {
  R c;       ///< ||e_i||
  R x, y;    ///< along the edge from its first end, and to its left, where a counter-clockwise polygon is
  R L1, L2;  ///< log of the squared distances of the ends
  R A;       ///< the angle under which the edge is seen

  PlaneEdge(const Segment<R>& segment, const Vec3<R>& point) {
    using std::atan, std::log, std::sqrt;
    const Vec3<R> e = segment[1] - segment[0], u = point - segment[0];
    c = sqrt(R(e[0] * e[0] + e[1] * e[1]));
    x = (u[0] * e[0] + u[1] * e[1]) / c;
    y = (u[1] * e[0] - u[0] * e[1]) / c;
    L1 = log(R(x * x + y * y));
    L2 = log(R(x * x + y * y + c * c - 2 * c * x));
    A = atan(R(x / y)) + atan(R((c - x) / y));
  }
};

}  // namespace cageproof::closed_form::published
