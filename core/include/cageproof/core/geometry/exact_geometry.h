// SPDX-License-Identifier: MIT
// A flat element seen from a point: differences and products of its coordinates, computed exactly and rounded once.
#pragma once

#include "cageproof/core/geometry/element.h"
#include "cageproof/core/numbers/linear.h"

#include <array>

namespace cageproof {

/// Products of a triangle's geometry that cancel next to its plane, its edges' lines and its corners. Each is exact
/// except for one rounding to W's digits, and zero only where the exact product is: for all doubles, and for
/// multiprecision numbers within 16384 bits. Beyond that, and for numbers that are not finite, operations are rounded
/// to W's digits. Doubles within 160 bits take no heap memory in Mp200.
/// \tparam W Mp200, Mp400 or Mp2000
template <class W>
struct ExactTriangleIn {
  std::array<Vec3<W>, 3> p;        ///< corners minus the point
  std::array<Vec3<W>, 3> e;        ///< edges: corner i + 1 minus corner i
  Vec3<W> normal;                  ///< e[0] x e[1]
  std::array<Vec3<W>, 3> outward;  ///< e[i] x normal
  W volume;                        ///< normal . p[i], the same for every i
  std::array<W, 3> beside;         ///< outward[i] . p[i] = outward[i] . p[i + 1]
  std::array<W, 3> before, after;  ///< e[i] . p[i] and e[i] . p[i + 1]

  ExactTriangleIn(const Triangle<W>& t, const Vec3<W>& point);
};
using ExactTriangle = ExactTriangleIn<Mp200>;

/// Products that are the heights of a point over a triangle's sides and plane, once divided by lengths and areas. Signs
/// are exact; sizes have two roundings at most.
struct ExactHeights {
  double volume;                 ///< ExactTriangle::volume
  std::array<double, 3> beside;  ///< ExactTriangle::beside
  int volume_sign;               ///< -1, 0 or 1; sizes may leave double's range
  std::array<int, 3> beside_sign;
};

/// These products for any finite doubles; quick within 112 bits. \param exponent lengths are in units of 2^exponent
ExactHeights exact_heights(const Triangle<double>& t, const Vec3<double>& point, int exponent);

/// Products of a segment's geometry in the plane, exact as ExactTriangleIn's; third coordinates are ignored.
/// \tparam W Mp200, Mp400 or Mp2000
template <class W>
struct ExactSegmentIn {
  std::array<std::array<W, 2>, 2> p;  ///< ends minus the point
  std::array<W, 2> e;                 ///< end 1 minus end 0
  W cross;                            ///< e x p[i], the same for both ends: positive for points right of the line
  W before, after;                    ///< e . p[0] and e . p[1]
  W middle;                           ///< e . (p[0] + p[1]): zero over the middle

  ExactSegmentIn(const Segment<W>& s, const Vec3<W>& point);
};
using ExactSegment = ExactSegmentIn<Mp200>;

}  // namespace cageproof
