// SPDX-License-Identifier: MIT
// The bilinear quad as a surface: whether it is valid, planar, and whether a point lies on it, decided exactly.
#pragma once

#include "cageproof/core/geometry/element.h"

#include <array>
#include <optional>
#include <string>

namespace cageproof {

/// The first reason why a quad is not valid, or nothing for one that is: its projections onto the four planes through
/// three successive corners are strictly convex, with no angle of 180 degrees ([T18] Definition 1). Reasons, in this
/// order, with corners counted from 0: a coordinate is not finite, two corners coincide, three corners lie on a line,
/// it crosses itself (bow-tie), it folds over. Exact for any finite doubles.
std::optional<std::string> invalid_because(const Quad<double>& q);

/// Whether the four corners lie in one plane, exactly.
bool is_planar(const Quad<double>& q);

/// A place on a bilinear quad: parameters in [0, 1], and the bilinear basis functions of corners 0..3 ([T18] Eq 3).
struct BilinearPoint {
  double u = 0, v = 0;
  std::array<double, 4> basis{};
};

/// The parameters of a point that lies on the quad, border included, or nothing. Whether it does is decided exactly for
/// any finite doubles ([T18] Section 3.3 without its thresholds and its division by zero); parameters and basis are
/// rounded. For a planar quad: the roots of the quadratic that Eq 19 solves, for others the kernel of Eq 17. Where an
/// invalid quad covers a point more than once, some parameters that reproduce it. Nothing for coordinates that are not
/// finite.
std::optional<BilinearPoint> on_quad(const Quad<double>& q, const Vec3<double>& point);

/// on_quad() for numbers of up to 200 digits, decided exactly as well. Nothing where a number's exponent of two is
/// beyond +-2^14.
std::optional<BilinearPoint> on_quad(const Quad<Mp200>& q, const Vec3<Mp200>& point);

/// The two triangles whose solid angles add up to that of a bilinear quad, seen from a point.
enum class SeenTriangles {
  Diagonal02,  ///< corners 0 1 2 and 0 2 3
  Diagonal13,  ///< corners 1 2 3 and 1 3 0
  Coplanar     ///< the point lies in a plane of three corners, where a triangle may be met on its inside or its outside
};

/// Between the two pairs of triangles, within the corners' tetrahedron, the quad itself decides: the diagonal is 13
/// where k_1 k_3 < k_0 k_2 for the point's barycentric coordinates k. Exact for any finite doubles.
SeenTriangles seen_triangles(const Quad<double>& q, const Vec3<double>& point);

/// seen_triangles() in multiprecision, with rounded products.
SeenTriangles seen_triangles(const Quad<Mp200>& q, const Vec3<Mp200>& point);

}  // namespace cageproof
