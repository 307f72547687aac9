// SPDX-License-Identifier: MIT
// A triangle seen from a point: the distances, heights and directions that every closed form is built from.
#pragma once

#include "cageproof/closed_form/wide.h"
#include "cageproof/core/element.h"

#include <array>

namespace cageproof::closed_form {

/// One edge from corner e to corner e + 1, seen from the point.
template <Scalar R>
struct FrameEdge {
  Vec3<R> u;   ///< unit direction
  Vec3<R> nu;  ///< outward in-plane unit normal, u x n
  Vec3<R> D;   ///< from the point to the nearest point of the edge's line
  R length, h; ///< h: signed in-plane distance from the point's projection to the line, positive inside
  R s0, s1;    ///< arc length of the corners from the nearest point, s1 - s0 = length
  R r0, r1;    ///< distances of the corners
  R D2;        ///< |D|^2
};

/// Geometry in units of `unit`, a power of two near the largest distance, so that no power of a distance overflows.
template <Scalar R>
struct Frame {
  std::array<Vec3<R>, 3> p;  ///< corners minus point
  std::array<R, 3> r;        ///< distances of the corners
  std::array<FrameEdge<R>, 3> edges;
  Vec3<R> n;  ///< unit normal
  R d;        ///< signed height of the point: (point - corner).n, negative inside a cage
  R area2;    ///< twice the area
  R unit;
  int far_corner;

  Frame(const Triangle<R>& t, const Vec3<R>& eta);

  /// Gradient of corner k's hat function (tangent to the triangle).
  Vec3<R> hat_gradient(int k) const {
    const FrameEdge<R>& opposite = edges[(k + 1) % 3];
    return -(opposite.length / area2) * opposite.nu;
  }
  /// Corner k's hat function, extended affinely to the point's projection.
  R hat(int k) const {
    const FrameEdge<R>& opposite = edges[(k + 1) % 3];
    return opposite.h * opposite.length / area2;
  }
  /// The distance of the first corner, or of the second for a point next to the first: never small against the triangle.
  const R& farthest() const { return r[far_corner]; }
  /// r[i] - farthest(), to full relative accuracy.
  R distance_rest(int i) const {
    if (i == far_corner) return R(0);
    // Corner i is one edge away from the far one, in one direction or the other.
    const FrameEdge<R>& e = edges[(far_corner + 1) % 3 == i ? far_corner : i];
    const R step = e.length * (e.s0 + e.s1) / (e.r0 + e.r1);
    return (far_corner + 1) % 3 == i ? step : R(-step);
  }
  /// Edge i's midpoint minus the far corner, along the edge.
  R midpoint_rest(int i) const {
    const FrameEdge<R>& e = edges[i];
    if (far_corner == i) return e.length / 2;
    if (far_corner == (i + 1) % 3) return -e.length / 2;
    const FrameEdge<R>&before = edges[(i + 2) % 3], &after = edges[(i + 1) % 3];
    return (before.length * before.u.dot(e.u) - after.length * after.u.dot(e.u)) / 2;
  }
  /// True when the point lies on the triangle, its border included.
  bool on_triangle() const { return d == 0 && edges[0].h >= 0 && edges[1].h >= 0 && edges[2].h >= 0; }
};

/// The power of two just above x > 0; one for multiprecision, whose exponents do not overflow.
template <Scalar R>
R unit_of(const R& x) {
  if constexpr (is_multiprecision<R>) return R(1);
  else return std::ldexp(R(1), std::ilogb(x) + 1);
}

/// Edge i, its in-plane normal e x N and N itself, exactly: 200 digits hold these products of doubles over 30 decades of size.
template <Scalar R>
struct ExactPlane {
  std::array<Vec3<Mp200>, 3> p;
  Vec3<Mp200> normal;

  ExactPlane(const Triangle<R>& t, const Vec3<R>& eta, const R& scale) {
    for (int i = 0; i < 3; ++i) p[i] = convert<Mp200>(Vec3<R>(t[i] * scale)) - convert<Mp200>(Vec3<R>(eta * scale));
    normal = Vec3<Mp200>(p[1] - p[0]).cross(Vec3<Mp200>(p[2] - p[0]));
  }
  R height() const { return static_cast<R>(Mp200(normal.dot(p[0]))); }
  R beside(int i) const {
    return static_cast<R>(Mp200(Vec3<Mp200>(p[(i + 1) % 3] - p[i]).cross(normal).dot(p[i])));
  }
};

/// Below this multiple of its terms, in frame units, a product in Wide arithmetic may have lost its sign, and is done again exactly.
template <std::floating_point R>
constexpr R doubtful() {
  return 4096 * std::numeric_limits<R>::epsilon() * std::numeric_limits<R>::epsilon();
}

template <Scalar R>
Frame<R>::Frame(const Triangle<R>& t, const Vec3<R>& eta) {
  using std::abs, std::max, std::sqrt;
  R largest = 0;
  for (int i = 0; i < 3; ++i)
    for (int c = 0; c < 3; ++c) largest = max(largest, R(max(abs(t[i][c] - eta[c]), abs(t[(i + 1) % 3][c] - t[i][c]))));
  unit = unit_of(largest);
  const R scale = 1 / unit;
  std::array<WideVec<Wide<R>>, 3> wp, we;
  for (int i = 0; i < 3; ++i) {
    // Scaling by a power of two is exact, so it may come before the difference.
    wp[i] = wide_difference<R>(t[i] * scale, eta * scale);
    we[i] = wide_difference<R>(t[(i + 1) % 3] * scale, t[i] * scale);
    p[i] = narrow<R>(wp[i]);
    r[i] = sqrt(p[i].dot(p[i]));
  }
  far_corner = r[0] >= r[1] ? 0 : 1;
  if (r[2] > r[far_corner]) far_corner = 2;
  const WideVec<Wide<R>> normal = cross(we[0], we[1]);
  const Vec3<R> N = narrow<R>(normal);
  area2 = sqrt(N.dot(N));
  n = N / area2;
  int nearest = r[0] <= r[1] ? 0 : 1;
  if (r[2] < r[nearest]) nearest = 2;
  R volume = static_cast<R>(dot(normal, wp[nearest]));
  if constexpr (!is_multiprecision<R>)
    if (abs(volume) <= doubtful<R>() * r[nearest]) volume = ExactPlane<R>(t, eta, scale).height();
  d = -volume / area2;
  for (int i = 0; i < 3; ++i) {
    FrameEdge<R>& e = edges[i];
    const int j = (i + 1) % 3;
    const Vec3<R> vector = narrow<R>(we[i]);
    e.length = sqrt(vector.dot(vector));
    e.u = vector / e.length;
    const WideVec<Wide<R>> outward = cross(we[i], normal);
    e.nu = narrow<R>(outward) / (e.length * area2);
    const R near_end = r[i] <= r[j] ? r[i] : r[j];
    R beside = static_cast<R>(dot(outward, wp[r[i] <= r[j] ? i : j]));
    if constexpr (!is_multiprecision<R>)
      if (abs(beside) <= doubtful<R>() * near_end) beside = ExactPlane<R>(t, eta, scale).beside(i);
    e.h = beside / (e.length * area2);
    e.s0 = static_cast<R>(dot(we[i], wp[i])) / e.length;
    e.s1 = static_cast<R>(dot(we[i], wp[j])) / e.length;
    e.r0 = r[i];
    e.r1 = r[j];
    e.D = e.h * e.nu - d * n;
    e.D2 = e.h * e.h + d * d;
  }
}

}  // namespace cageproof::closed_form
