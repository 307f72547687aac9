// SPDX-License-Identifier: MIT
// A segment of the plane as its point sees it.
#pragma once

#include "../exact_element.h"
#include "../local_corners.h"

#include <optional>

namespace cageproof::quadrature_ref {

/// A segment as eta sees it: ends v_k - eta, the edge v_1 - v_0, and numbers derived from these.
template <Scalar R>
struct SegmentFrame : LocalCorners<R, 2, 1> {
  Vec3<R> normal;  ///< unit, outward: to the right of v_0 -> v_1
  R height;        ///< x . normal of every x on the segment
  R extent;        ///< the segment's length
  R start, end;    ///< where along the edge the ends are, seen from the point's projection
};

/// The frame; nothing for a segment without length or an input that is not finite.
template <Scalar R>
std::optional<SegmentFrame<R>> segment_frame(std::span<const Vec3<R>> corners, const Vec3<R>& point) {
  SegmentFrame<R> s;
  if (!s.set(corners, point)) return std::nullopt;
  const Vec3<R>& edge = s.edges[0];
  s.extent = length(edge);
  if (!(s.extent > 0)) return std::nullopt;
  s.normal = {edge[1] / s.extent, -edge[0] / s.extent, R(0)};
  if constexpr (std::same_as<R, Mp200>) {
    const auto exact = exact_segment(corners, point, s.exponent);
    if (!exact) return std::nullopt;
    s.height = exact->height / s.extent;
    s.start = exact->start / s.extent;
    s.end = exact->end / s.extent;
  } else {
    // The nearest end gives the height with the smallest rounding error; dividing last keeps an exact zero.
    const Vec3<R>& nearest =
        dot(s.corners[1], s.corners[1]) < dot(s.corners[0], s.corners[0]) ? s.corners[1] : s.corners[0];
    s.height = (nearest[0] * edge[1] - nearest[1] * edge[0]) / s.extent;
    s.start = dot(s.corners[0], edge) / s.extent;
    s.end = dot(s.corners[1], edge) / s.extent;
  }
  return s;
}

}  // namespace cageproof::quadrature_ref
