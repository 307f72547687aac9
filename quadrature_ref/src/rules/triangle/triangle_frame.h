// SPDX-License-Identifier: MIT
// A triangle as its point sees it.
#pragma once

#include "../local_corners.h"

#include <optional>

namespace cageproof::quadrature_ref {

/// A triangle as eta sees it: corners v_k - eta, edges v_{k+1} - v_k, and numbers derived from these.
template <Scalar R>
struct TriangleFrame : LocalCorners<R, 3> {
  Vec3<R> normal;  ///< unit, outward
  R height;        ///< x . normal of every x on the triangle
  R twice_area;
};

/// The frame; nothing for a triangle without area or an input that is not finite.
template <Scalar R>
std::optional<TriangleFrame<R>> triangle_frame(std::span<const Vec3<R>> corners, const Vec3<R>& point) {
  TriangleFrame<R> t;
  if (!t.set(corners, point)) return std::nullopt;
  const Vec3<R> area_vector = t.edges[0].cross(t.edges[1]);
  t.twice_area = length(area_vector);
  if (!(t.twice_area > 0)) return std::nullopt;
  for (int i = 0; i < 3; ++i) t.normal[i] = area_vector[i] / t.twice_area;
  // The nearest corner gives the height with the smallest rounding error; dividing last keeps an exact zero.
  const auto nearest = std::ranges::min_element(t.corners, {}, [](const Vec3<R>& p) { return dot(p, p); });
  t.height = dot(*nearest, area_vector) / t.twice_area;
  return t;
}

template <Scalar To, Scalar From>
TriangleFrame<To> convert(const TriangleFrame<From>& from) {
  TriangleFrame<To> to;
  for (int k = 0; k < 3; ++k) {
    to.corners[k] = cageproof::convert<To>(from.corners[k]);
    to.edges[k] = cageproof::convert<To>(from.edges[k]);
  }
  to.normal = cageproof::convert<To>(from.normal);
  to.height = static_cast<To>(from.height);
  to.twice_area = static_cast<To>(from.twice_area);
  to.exponent = from.exponent;
  return to;
}

}  // namespace cageproof::quadrature_ref
