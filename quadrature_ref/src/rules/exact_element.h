// SPDX-License-Identifier: MIT
// Products of an element's coordinates that cancel next to its plane, its lines and its corners: exact, then rounded
// once. They are formed of vectors from the point to the corners and of squared lengths. They share no code with core's
// exact geometry, which the closed forms use, so that both can be compared.
#pragma once

#include "cageproof/core/numbers/linear.h"

#include <array>
#include <optional>
#include <span>

namespace cageproof::quadrature_ref {

/// A triangle seen from a point, lengths in units of 2^exponent.
struct ExactTriangle {
  std::array<Vec3<Mp200>, 3> corners;  ///< minus the point
  std::array<Vec3<Mp200>, 3> edges;    ///< corner i + 1 minus corner i
  Vec3<Mp200> normal;                  ///< outward, twice the area long
  std::array<Vec3<Mp200>, 3> outward;  ///< edge i x normal: in the plane, the edge's length times the normal's
  Mp200 volume;                        ///< corner . normal, the same for all corners; height times twice the area
  std::array<Mp200, 3> inside;         ///< corner i . outward[i]
  std::array<Mp200, 3> start, end;     ///< edge i . corner i, edge i . corner i + 1
};

/// A segment in the plane seen from a point, in the same units.
struct ExactSegment {
  Mp200 height;      ///< corner . (edge turned to the right): height times length
  Mp200 start, end;  ///< edge . corner 0, edge . corner 1
};

/// The products; nothing where a number is not finite, or where the coordinates' bits spread over more than 100000.
std::optional<ExactTriangle> exact_triangle(std::span<const Vec3<Mp200>> corners, const Vec3<Mp200>& point,
                                            int exponent);
std::optional<ExactSegment> exact_segment(std::span<const Vec3<Mp200>> ends, const Vec3<Mp200>& point, int exponent);

/// For a bilinear quad: (corner k - point) . (edge from k cross edge to k - 1), k = 0 to 3; nothing as above.
std::optional<std::array<Mp200, 4>> exact_volumes(std::span<const Vec3<Mp200>> corners, const Vec3<Mp200>& point,
                                                  int exponent);

}  // namespace cageproof::quadrature_ref
