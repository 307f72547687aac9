// SPDX-License-Identifier: MIT
// A bilinear quad as its point sees it, the nearest corner first, with lines along its longer sides.
#pragma once

#include "cageproof/core/linear.h"

#include <array>
#include <cmath>
#include <optional>
#include <span>

namespace cageproof::adaptive_qmvc {

/// How a frame's units and corners are its caller's.
struct FrameUnit {
  std::array<int, 4> corner;  ///< the caller's number of corners 0 .. 3
  int sign;                   ///< -1 where the corners are taken clockwise
  int exponent;               ///< lengths are in units of 2^exponent
};

/// xi - eta = a + u e + v b + u v w, in the frame's units. N = n + u n_u + v n_v and
/// N.x = g00 + v g01 + u (g10 + v g11), to a rounding of their terms.
template <class R>
struct QuadFrame {
  Vec3<R> a;      ///< corner 0 - eta, the nearest one
  Vec3<R> a1;     ///< corner 1 - eta
  Vec3<R> e;      ///< corner 1 - corner 0
  Vec3<R> b, b1;  ///< corner 3 - corner 0, corner 2 - corner 1
  Vec3<R> w;      ///< b1 - b: zero for a parallelogram
  Vec3<R> n, n_u, n_v;
  R g00, g01, g10, g11;
  FrameUnit unit;

  /// Along the line v: its start, seen from eta, and its direction.
  Vec3<R> start(const R& v) const { return a + v * b; }
  Vec3<R> direction(const R& v) const { return e + v * w; }
};

/// Nothing where a difference is not finite.
template <class R>
std::optional<QuadFrame<R>> quad_frame(std::span<const Vec3<R>> corners, const Vec3<R>& point) {
  using std::abs, std::frexp, std::isfinite, std::ldexp;
  QuadFrame<R> q;
  std::array<Vec3<R>, 4> x;
  R extent = 0;
  for (int k = 0; k < 4; ++k) {
    x[k] = corners[k] - point;
    for (int i = 0; i < 3; ++i) {
      if (!isfinite(x[k][i])) return std::nullopt;
      if (abs(x[k][i]) > extent) extent = abs(x[k][i]);
    }
  }
  frexp(extent, &q.unit.exponent);
  const R unit = ldexp(R(1), -q.unit.exponent);
  const auto scaled = [&](const Vec3<R>& p) { return Vec3<R>(unit * p); };
  for (Vec3<R>& p : x) p = scaled(p);
  int nearest = 0;
  for (int k = 1; k < 4; ++k)
    if (x[k].dot(x[k]) < x[nearest].dot(x[nearest])) nearest = k;
  const auto side = [&](int from, int to) {
    return scaled(corners[(nearest + to) % 4] - corners[(nearest + from) % 4]);
  };
  const Vec3<R> s01 = side(0, 1), s32 = side(3, 2), s03 = side(0, 3), s12 = side(1, 2);
  const bool turned = s01.dot(s01) + s32.dot(s32) < s03.dot(s03) + s12.dot(s12);
  q.unit.sign = turned ? -1 : 1;
  for (int k = 0; k < 4; ++k) q.unit.corner[k] = (nearest + (turned ? 4 - k : k)) % 4;
  q.a = x[q.unit.corner[0]];
  q.a1 = x[q.unit.corner[1]];
  q.e = turned ? s03 : s01;
  q.b = turned ? s01 : s03;
  q.b1 = turned ? s32 : s12;
  q.w = q.b1 - q.b;
  q.n = q.e.cross(q.b);
  q.n_u = q.e.cross(q.w);
  q.n_v = q.w.cross(q.b);
  q.g00 = q.a.dot(q.n);
  q.g01 = q.a.dot(q.n_v);
  q.g10 = q.a.dot(q.n_u);
  q.g11 = q.b.dot(q.n_u);
  return q;
}

/// Whether the quad's normals at opposite corners look in opposite directions: sheets over each other add to the
/// weights with opposite signs.
template <class R>
bool is_folded(const QuadFrame<R>& q) {
  const Vec3<R> after = q.n + q.n_u, before = q.n + q.n_v;
  return q.n.dot(after + q.n_v) < R(0) || after.dot(before) < R(0);
}

}  // namespace cageproof::adaptive_qmvc
