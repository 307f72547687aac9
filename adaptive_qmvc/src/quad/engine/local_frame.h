// SPDX-License-Identifier: MIT
// A bilinear quad about one of its own points, next to the point that it is seen from: what is small there is known to
// its own rounding, not to that of the quad's size.
#pragma once

#include "quad/engine/quad_frame.h"
#include "cageproof/closed_form/arithmetic/double_double.h"
#include "cageproof/core/numbers/linear.h"

#include <algorithm>
#include <array>
#include <concepts>
#include <span>
#include <type_traits>

namespace cageproof::adaptive_qmvc {

/// xi - eta = a + t e + s b + s t w at (u0 + t, v0 + s), in the units of a QuadFrame. N = n + t n_u + s n_v and
/// N.x = g00 + s g01 + t (g10 + s g11), as precise as the frame's.
template <class R>
struct LocalFrame {
  R u0 = R(0), v0 = R(0);
  R first = R(0), last = R(1);  ///< t at the ends of the lines
  R above = R(1);               ///< s at the last line: 1 - v0, which a rounded v0 would not tell
  Vec3<R> a, e, b, w;
  Vec3<R> n, n_u, n_v;
  R g00, g01, g10, g11;

  /// About corner 0.
  explicit LocalFrame(const QuadFrame<R>& q)
      : a(q.a),
        e(q.e),
        b(q.b),
        w(q.w),
        n(q.n),
        n_u(q.n_u),
        n_v(q.n_v),
        g00(q.g00),
        g01(q.g01),
        g10(q.g10),
        g11(q.g11) {}

  /// About (u0, v0), which eta sees at `a`.
  LocalFrame(const QuadFrame<R>& q, const R& u, const R& v, const Vec3<R>& seen)
      : u0(u),
        v0(v),
        first(-u),
        last(1 - u),
        above(1 - v),
        a(seen),
        e(q.along(v)),
        b(q.across(u)),
        w(q.w),
        // Not e x b, which cancels next to a corner whose sides lie on one line: there the normal vanishes.
        n(q.normal_at(u, v)),
        n_u(q.n_u),
        n_v(q.n_v) {
    if (q.g00 == R(0) && q.g01 == R(0) && q.g10 == R(0) && q.g11 == R(0)) {
      // In the plane of a flat quad, where a rounding of `a` would be all of the result.
      g00 = g01 = g10 = g11 = R(0);
      return;
    }
    // The mean of the corners', or that of `a`, whichever adds the smaller terms: next to a twisted quad `a` is short.
    const auto size = [](const R& x) { return x < R(0) ? R(-x) : x; };
    const R from_corners = (1 - v) * ((1 - u) * size(q.height[0]) + u * size(q.height[1])) +
                           v * (u * size(q.height[2]) + (1 - u) * size(q.height[3]));
    const R from_place = size(a[0] * n[0]) + size(a[1] * n[1]) + size(a[2] * n[2]);
    g00 = from_corners < from_place ? q.height_at(u, v) : R(a.dot(n));
    g01 = q.height_by_v(u);
    g10 = q.height_by_u(v);
    g11 = q.g11;
  }

  /// The same in another scalar, every number rounded once.
  template <class From>
  explicit LocalFrame(const LocalFrame<From>& q)
      : u0(q.u0),
        v0(q.v0),
        first(q.first),
        last(q.last),
        above(q.above),
        a(q.a.template cast<R>()),
        e(q.e.template cast<R>()),
        b(q.b.template cast<R>()),
        w(q.w.template cast<R>()),
        n(q.n.template cast<R>()),
        n_u(q.n_u.template cast<R>()),
        n_v(q.n_v.template cast<R>()),
        g00(q.g00),
        g01(q.g01),
        g10(q.g10),
        g11(q.g11) {}

  /// The line v0 + s where t = 0, seen from eta, and its direction.
  Vec3<R> start(const R& s) const { return a + s * b; }
  Vec3<R> direction(const R& s) const { return e + s * w; }
};

/// The scalar with twice R's digits that a point next to the quad is seen in.
template <class R>
using Seen = std::conditional_t<
    std::same_as<R, double>, closed_form::DoubleDouble,
    std::conditional_t<std::same_as<R, Mp50>, Mp100, std::conditional_t<std::same_as<R, Mp100>, Mp200, R>>>;

/// xi(u, v) - eta in the units of `q`: differences in twice the digits, then rounded.
template <Scalar R>
Vec3<R> seen_at(const QuadFrame<R>& q, std::span<const Vec3<R>> corners, const Vec3<R>& point, const R& u, const R& v) {
  using std::ldexp;
  using W = Seen<R>;
  const R unit = ldexp(R(1), -q.unit.exponent);
  Vec3<R> seen;
  for (int i = 0; i < 3; ++i) {
    std::array<W, 4> x;
    for (int k = 0; k < 4; ++k) {
      const R& corner = corners[q.unit.corner[k]][i];
      if constexpr (std::same_as<R, double>) {
        const W exact = W::sum(corner, -point[i]);
        x[k] = W(exact.high * unit, exact.low * unit);
      } else {
        x[k] = (W(corner) - W(point[i])) * W(unit);
      }
    }
    const W along = x[1] - x[0], across = x[3] - x[0], twist = (x[2] - x[1]) - across;
    seen[i] = static_cast<R>(x[0] + W(u) * along + W(v) * (across + W(u) * twist));
  }
  return seen;
}

/// The frame about the point of line v that is nearest to eta.
template <Scalar R>
LocalFrame<R> frame_at(const QuadFrame<R>& q, std::span<const Vec3<R>> corners, const Vec3<R>& point, const R& v) {
  const Vec3<R> a = q.start(v), e = q.direction(v);
  const R length2 = e.dot(e);
  const R u = length2 > R(0) ? std::clamp(R(-a.dot(e) / length2), R(0), R(1)) : R(0);
  return LocalFrame<R>(q, u, v, seen_at<R>(q, corners, point, u, v));
}

}  // namespace cageproof::adaptive_qmvc
