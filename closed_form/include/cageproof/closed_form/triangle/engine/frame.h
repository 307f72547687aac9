// SPDX-License-Identifier: MIT
// A triangle seen from a point: the distances, heights and directions that every closed form is built from.
#pragma once

#include "cageproof/closed_form/arithmetic/names.h"
#include "cageproof/core/numbers/scalar_names.h"
#include "cageproof/core/numbers/vector.h"

#include <array>
#include <cmath>

namespace cageproof {
template <class W>
struct ExactTriangleIn;
}

namespace cageproof::closed_form::triangle {

/// One edge from corner e to corner e + 1, seen from the point.
template <class R>
struct FrameEdge {
  Vec3<R> u;    ///< unit direction
  Vec3<R> nu;   ///< outward in-plane unit normal, u x n
  R length, h;  ///< h: signed in-plane distance from the point's projection to the line, positive inside
  R s0, s1;     ///< arc length of the corners from the nearest point, s1 - s0 = length
  R r0, r1;     ///< distances of the corners
  R D2;         ///< squared distance of the line: h^2 + d^2
};

/// Geometry in units of `unit`. For frames seen in double that is a power of two near the largest distance, so that no
/// power of a distance overflows; for others it is 1.
template <class R>
struct Frame {
  std::array<Vec3<R>, 3> p;  ///< corners minus point
  std::array<R, 3> r;        ///< distances of the corners
  std::array<FrameEdge<R>, 3> edges;
  Vec3<R> n;       ///< unit normal
  R d;             ///< signed height of the point: (point - corner).n, negative inside a cage
  R area2;         ///< twice the area
  R unit{1};       ///< the input's lengths are these times `unit`; for the caller's, see PointMoments::unit()
  int far_corner;  ///< the corner farthest from the point
  /// In double: powers of distances may leave the range of numbers, small distances have become zero, or the normal's
  /// terms cancel. Other members may be meaningless then; the point is seen in multiprecision instead.
  bool extreme = false;

  /// Empty: plain_frame() fills it in.
  Frame() = default;
  /// From exact differences: exact_frame.h.
  Frame(const Triangle<R>& t, const Vec3<R>& eta) requires Scalar<R>;
  /// From exact products, each rounded once to a wide type, tracked or not: exact_frame.h. Lengths are those of `x`.
  template <class W>
  explicit Frame(const ExactTriangleIn<W>& x);
  /// The same geometry in a tracked type: exact_frame.h.
  template <class S>
  explicit Frame(const Frame<S>& other);
  /// In tracked double-doubles, from exact differences; zeros, unit and nearest corners are those seen in double.
  Frame(const Frame<double>& seen, const Triangle<double>& t,
        const Vec3<double>& eta) requires std::same_as<R, Tracked<DoubleDouble>>;

  /// Gradient of corner k's hat function (tangent to the triangle).
  Vec3<R> hat_gradient(int k) const {
    const FrameEdge<R>& opposite = edges[(k + 1) % 3];
    const R slope = -opposite.length / area2;
    return {slope * opposite.nu[0], slope * opposite.nu[1], slope * opposite.nu[2]};
  }
  /// Corner k's hat function, extended affinely to the point's projection.
  R hat(int k) const {
    const FrameEdge<R>& opposite = edges[(k + 1) % 3];
    return opposite.h * opposite.length / area2;
  }
  /// Twice the area over the squared longest edge: the height over it, relative to its length.
  R shape() const {
    R longest = edges[0].length;
    for (int i = 1; i < 3; ++i)
      if (edges[i].length > longest) longest = edges[i].length;
    return area2 / (longest * longest);
  }
  /// The distance of the corner `far_corner`, the farthest: never small against the triangle.
  const R& farthest() const { return r[far_corner]; }
  /// r[i] - farthest(), to full relative accuracy.
  R distance_rest(int i) const {
    if (i == far_corner) return R(0);
    // Corner i is one edge away from the far one, in one direction or the other.
    const FrameEdge<R>& e = edges[(far_corner + 1) % 3 == i ? far_corner : i];
    const R step = e.length * (e.s0 + e.s1) / (e.r0 + e.r1);
    return (far_corner + 1) % 3 == i ? step : R(-step);
  }
  /// True when the point lies on the triangle, its border included.
  bool on_triangle() const { return d == 0 && edges[0].h >= 0 && edges[1].h >= 0 && edges[2].h >= 0; }
  void find_far_corner() {
    far_corner = r[0] >= r[1] ? 0 : 1;
    if (r[2] > r[far_corner]) far_corner = 2;
  }

 private:
  void set(const Triangle<R>& t, const Vec3<R>& eta) requires std::same_as<R, double>;
};

/// Distance of the triangle from the point.
template <class R>
R distance_of(const Frame<R>& f) {
  using std::abs, std::sqrt;
  bool within = true;
  for (const FrameEdge<R>& e : f.edges) within = within && e.h >= R(0);
  if (within) return abs(f.d);
  R least = f.farthest();
  for (const FrameEdge<R>& e : f.edges) {
    const bool foot = e.s0 <= R(0) && e.s1 >= R(0);
    const R nearest = foot ? R(sqrt(e.D2)) : e.r0 < e.r1 ? e.r0 : e.r1;
    if (nearest < least) least = nearest;
  }
  return least;
}

}  // namespace cageproof::closed_form::triangle
