// SPDX-License-Identifier: MIT
// A bilinear quad as its point sees it, expanded about a parameter (c_u, c_v): with a = u - c_u, b = v - c_v
//   xi - eta = X + aA + bB + abW,   N = xi_u x xi_v = A x B + a A x W + b W x B,
//   N.(xi - eta) = (A x B).X + a (A x W).X + b (W x B).X - ab det(A, B, W).
// The last: of the terms in ab, det(A, W, B) + det(B, A, W) + det(W, A, B) = (-1 - 1 + 1) det(A, B, W).
#pragma once

#include "../exact_element.h"
#include "../local_corners.h"

#include "cageproof/quadrature_ref/kernel.h"

#include <optional>

namespace cageproof::quadrature_ref {

/// The expansion about one parameter.
template <Scalar R>
struct QuadExpansion {
  R u, v;                                   ///< c
  Vec3<R> base;                             ///< X = xi(c) - eta
  Vec3<R> along_u, along_v, twist;          ///< A = xi_u(c), B = xi_v(c), W = q0 - q1 + q2 - q3
  Vec3<R> normal, normal_u, normal_v;       ///< A x B, A x W, W x B
  R height, height_u, height_v, height_uv;  ///< coefficients of N.x: 1, a, b, ab

  /// The point at (a, b) off c: position, hat functions, normal (not of unit length) and height; not the weight.
  void set(const R& a, const R& b, Node<R>& node) const {
    const R ab = a * b;
    for (int i = 0; i < 3; ++i) node.x[i] = base[i] + a * along_u[i] + b * along_v[i] + ab * twist[i];
    set_surface(a, b, ab, node);
  }
  /// All of `set` but the position.
  void set_surface(const R& a, const R& b, const R& ab, Node<R>& node) const {
    const R p = u + a, q = v + b, p_left = 1 - p, q_left = 1 - q;
    for (int i = 0; i < 3; ++i) node.normal[i] = normal[i] + a * normal_u[i] + b * normal_v[i];
    node.height = height + a * height_u + b * height_v + ab * height_uv;
    node.hat = {p_left * q_left, p * q_left, p * q, p_left * q};
  }
};

/// Corners q_k - eta and edges q_{k+1} - q_k.
template <Scalar R>
struct QuadFrame : LocalCorners<R, 4> {
  Vec3<R> twist;               ///< q0 - q1 + q2 - q3
  std::array<R, 4> heights{};  ///< N.x at the corners, exact but for one rounding; in 200 digits alone

  Vec3<R> along_u(const R& v) const { return this->edges[0] + twist * v; }
  Vec3<R> along_v(const R& u) const { return twist * u - this->edges[3]; }
  Vec3<R> at(const R& u, const R& v) const { return this->corners[0] + this->edges[0] * u + along_v(u) * v; }
};

/// The frame; nothing for a quad whose normal vanishes everywhere or an input that is not finite.
template <Scalar R>
std::optional<QuadFrame<R>> quad_frame(std::span<const Vec3<R>> corners, const Vec3<R>& point) {
  QuadFrame<R> q;
  if (!q.set(corners, point)) return std::nullopt;
  q.twist = -q.edges[0] - q.edges[2];
  const auto vanishes = [](const Vec3<R>& n) { return n[0] == 0 && n[1] == 0 && n[2] == 0; };
  if (vanishes(q.edges[3].cross(q.edges[0])) && vanishes(q.edges[0].cross(q.twist)) &&
      vanishes(q.edges[3].cross(q.twist)))
    return std::nullopt;
  if constexpr (std::same_as<R, Mp200>) {
    const auto volumes = exact_volumes(corners, point, q.exponent);
    if (!volumes) return std::nullopt;
    q.heights = *volumes;
  }
  return q;
}

/// The heights of an expansion about (u, v): from corner `nearest`, (a, b) away.
template <Scalar R>
void set_heights(const QuadFrame<R>& q, int nearest, const R& a, const R& b, QuadExpansion<R>& e) {
  R height, height_u, height_v;
  if constexpr (std::same_as<R, Mp200>) {
    const std::array<R, 4>& at = q.heights;
    height = at[nearest];
    height_u = nearest < 2 ? R(at[1] - at[0]) : R(at[2] - at[3]);
    height_v = nearest % 3 == 0 ? R(at[3] - at[0]) : R(at[2] - at[1]);
    e.height_uv = (at[0] - at[1]) + (at[2] - at[3]);
  } else {
    // A height that is zero everywhere stays so.
    const Vec3<R> along_u = nearest >= 2 ? Vec3<R>(-q.edges[2]) : q.edges[0];
    const Vec3<R> along_v = nearest % 3 == 0 ? Vec3<R>(-q.edges[3]) : q.edges[1];
    const Vec3<R>& corner = q.corners[nearest];
    height = dot(corner, Vec3<R>(along_u.cross(along_v)));
    height_u = dot(corner, Vec3<R>(along_u.cross(q.twist)));
    height_v = dot(corner, Vec3<R>(q.twist.cross(along_v)));
    e.height_uv = -dot(q.twist, Vec3<R>(along_u.cross(along_v)));
  }
  e.height = height + a * height_u + b * height_v + a * b * e.height_uv;
  e.height_u = height_u + b * e.height_uv;
  e.height_v = height_v + a * e.height_uv;
}

/// The expansion about (u, v). Where u and v are 0 or 1 its vectors are differences of corners.
template <Scalar R>
QuadExpansion<R> expand(const QuadFrame<R>& q, const R& u, const R& v) {
  QuadExpansion<R> e;
  e.u = u;
  e.v = v;
  // Corners and edges as they were given, not as sums of others.
  const int nearest = u * 2 < 1 ? (v * 2 < 1 ? 0 : 3) : (v * 2 < 1 ? 1 : 2);
  const R a = u - (nearest == 1 || nearest == 2 ? 1 : 0), b = v - (nearest >= 2 ? 1 : 0);
  const Vec3<R> along_u = nearest >= 2 ? Vec3<R>(-q.edges[2]) : q.edges[0];
  const Vec3<R> along_v = nearest == 1 || nearest == 2 ? q.edges[1] : Vec3<R>(-q.edges[3]);
  e.twist = q.twist;
  e.along_u = along_u + q.twist * b;
  e.along_v = along_v + q.twist * a;
  e.base = q.corners[nearest] + along_u * a + e.along_v * b;
  e.normal = e.along_u.cross(e.along_v);
  e.normal_u = e.along_u.cross(q.twist);
  e.normal_v = q.twist.cross(e.along_v);
  set_heights(q, nearest, a, b, e);
  return e;
}

template <Scalar To, Scalar From>
QuadExpansion<To> convert(const QuadExpansion<From>& from) {
  using cageproof::convert;
  const auto number = [](const From& x) { return static_cast<To>(x); };
  return {number(from.u),
          number(from.v),
          convert<To>(from.base),
          convert<To>(from.along_u),
          convert<To>(from.along_v),
          convert<To>(from.twist),
          convert<To>(from.normal),
          convert<To>(from.normal_u),
          convert<To>(from.normal_v),
          number(from.height),
          number(from.height_u),
          number(from.height_v),
          number(from.height_uv)};
}

}  // namespace cageproof::quadrature_ref
