// SPDX-License-Identifier: MIT
// The sum of the solid angles of many triangles at a point, with a bound of its error.
#pragma once

#include "cageproof/core/geometry/element.h"

#include <span>

namespace cageproof {

/// A number, and a bound of its error.
struct BoundedSum {
  double value = 0, bound = 0;
};

/// The sum of the solid angles of triangles, positive where the point is behind them. Each is twice an arc tangent (van
/// Oosterom and Strackee 1983); one that double loses digits of, next to edges, is taken in 50 digits.
/// \pre finite; the point is on no triangle, and the triangles have areas
BoundedSum solid_angles(std::span<const Triangle<double>> triangles, const Vec3<double>& point);

}  // namespace cageproof
