// SPDX-License-Identifier: MIT
// A bilinear quad as its point sees it, the nearest corner first, with lines along its longer sides.
#pragma once

#include "quad/engine/corner_heights.h"
#include "cageproof/core/numbers/linear.h"

#include <array>
#include <cmath>
#include <concepts>
#include <optional>
#include <span>

namespace cageproof::adaptive_qmvc {

/// How a frame's units and corners are its caller's.
struct FrameUnit {
  std::array<int, 4> corner;  ///< the caller's number of corners 0 .. 3
  int sign;                   ///< -1 where the corners are taken clockwise
  int exponent;               ///< lengths are in units of 2^exponent
};

/// xi - eta = a + u e + v b + u v w, in the frame's units. N = n + u n_u + v n_v, to a rounding of its terms, and N.x
/// is bilinear: g00 + v g01 + u (g10 + v g11), to a rounding of the largest of what it is at the corners.
template <class R>
struct QuadFrame {
  Vec3<R> a;                    ///< corner 0 - eta, the nearest one
  std::array<Vec3<R>, 4> seen;  ///< the corners - eta
  Vec3<R> e, e1;                ///< corner 1 - corner 0, corner 2 - corner 3
  Vec3<R> b, b1;                ///< corner 3 - corner 0, corner 2 - corner 1
  Vec3<R> w;                    ///< b1 - b: zero for a parallelogram
  Vec3<R> n, n_u, n_v;
  std::array<Vec3<R>, 4> normal;  ///< N at the corners, each from its own sides
  std::array<R, 4> height;        ///< N.x at the corners: in double to two roundings, whatever cancels
  R g00, g01, g10, g11;
  FrameUnit unit;

  QuadFrame() = default;
  /// The same in another scalar, every number rounded once.
  template <class From>
  explicit QuadFrame(const QuadFrame<From>& q)
      : a(q.a.template cast<R>()),
        e(q.e.template cast<R>()),
        e1(q.e1.template cast<R>()),
        b(q.b.template cast<R>()),
        b1(q.b1.template cast<R>()),
        w(q.w.template cast<R>()),
        n(q.n.template cast<R>()),
        n_u(q.n_u.template cast<R>()),
        n_v(q.n_v.template cast<R>()),
        g00(q.g00),
        g01(q.g01),
        g10(q.g10),
        g11(q.g11),
        unit(q.unit) {
    for (int k = 0; k < 4; ++k) {
      height[k] = R(q.height[k]);
      seen[k] = q.seen[k].template cast<R>();
      normal[k] = q.normal[k].template cast<R>();
    }
  }

  /// Takes heights over the corners, and what N.x is made of from them.
  void take(const std::array<R, 4>& heights) {
    height = heights;
    g00 = height[0];
    g01 = height[3] - height[0];
    g10 = height[1] - height[0];
    g11 = (height[2] - height[3]) - g10;
  }

  /// Along the line v: its start, seen from eta, and its direction.
  Vec3<R> start(const R& v) const { return a + v * b; }
  Vec3<R> direction(const R& v) const { return e + v * w; }

  /// Means of what the corners and sides have, in which short sides lose nothing to long ones.
  Vec3<R> along(const R& v) const { return (1 - v) * e + v * e1; }
  Vec3<R> across(const R& u) const { return (1 - u) * b + u * b1; }
  Vec3<R> normal_at(const R& u, const R& v) const {
    return (1 - v) * ((1 - u) * normal[0] + u * normal[1]) + v * (u * normal[2] + (1 - u) * normal[3]);
  }
  /// N.x and its derivatives by u and v, as means of what the corners have.
  R height_at(const R& u, const R& v) const {
    return (1 - v) * ((1 - u) * height[0] + u * height[1]) + v * (u * height[2] + (1 - u) * height[3]);
  }
  R height_by_u(const R& v) const { return (1 - v) * (height[1] - height[0]) + v * (height[2] - height[3]); }
  R height_by_v(const R& u) const { return (1 - u) * (height[3] - height[0]) + u * (height[2] - height[1]); }
};

/// The cross product of two edges of a triangle p + q + r = 0, in their order, whichever is the longest: the others
/// have the smaller terms.
template <class R>
Vec3<R> area_vector(const Vec3<R>& p, const Vec3<R>& q, const Vec3<R>& r) {
  const R p2 = p.dot(p), q2 = q.dot(q), r2 = r.dot(r);
  if (p2 > q2 && p2 > r2) return q.cross(r);
  return r2 > q2 ? p.cross(q) : r.cross(p);
}

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
  for (int k = 0; k < 4; ++k) q.seen[k] = x[q.unit.corner[k]];
  q.a = q.seen[0];
  q.e = turned ? s03 : s01;
  q.e1 = turned ? s12 : s32;
  q.b = turned ? s01 : s03;
  q.b1 = turned ? s32 : s12;
  q.w = q.b1 - q.b;
  const auto diagonal = [&](int from, int to) {
    return scaled(corners[q.unit.corner[to]] - corners[q.unit.corner[from]]);
  };
  const Vec3<R> d02 = diagonal(0, 2), d13 = diagonal(1, 3);
  q.normal = {area_vector<R>(q.e, d13, -q.b), area_vector<R>(q.b1, -d02, q.e), area_vector<R>(-q.e1, -d13, q.b1),
              area_vector<R>(-q.b, d02, -q.e1)};
  q.n = q.normal[0];
  // Opposite sides differ by w, and the shorter one has the smaller terms.
  const auto shorter = [](const Vec3<R>& one, const Vec3<R>& other) {
    return other.dot(other) < one.dot(one) ? other : one;
  };
  const Vec3<R> across = shorter(q.b, q.b1);
  q.n_u = shorter(q.e, q.e1).cross(q.w);
  q.n_v = q.w.cross(across);
  std::array<R, 4> heights;
  for (int k = 0; k < 4; ++k) {
    if constexpr (std::same_as<R, double>) {
      const auto corner = [&](int step) -> const Vec3<R>& { return corners[q.unit.corner[(k + step) % 4]]; };
      heights[k] = height_at_corner(corner(3), corner(0), corner(1), point, q.unit.exponent);
    } else {
      heights[k] = q.seen[k].dot(q.normal[k]);
    }
  }
  q.take(heights);
  return q;
}

/// Whether one side is more than four times as long as the opposite one.
template <class R>
bool is_uneven(const QuadFrame<R>& q) {
  const auto differ = [](const Vec3<R>& one, const Vec3<R>& other) {
    const R one2 = one.dot(one), other2 = other.dot(other);
    return one2 > 16 * other2 || other2 > 16 * one2;
  };
  return differ(q.e, q.e1) || differ(q.b, q.b1);
}

/// Whether the quad's normals at opposite corners look in opposite directions: sheets over each other add to the
/// weights with opposite signs.
template <class R>
bool is_folded(const QuadFrame<R>& q) {
  const Vec3<R> after = q.n + q.n_u, before = q.n + q.n_v;
  return q.n.dot(after + q.n_v) < R(0) || after.dot(before) < R(0);
}

}  // namespace cageproof::adaptive_qmvc
