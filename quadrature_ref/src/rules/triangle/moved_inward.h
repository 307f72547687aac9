// SPDX-License-Identifier: MIT
#pragma once

#include "../adaptive.h"
#include "../converted.h"
#include "polar_frame.h"

namespace cageproof::quadrature_ref {

/// The frame of a point; a point on the triangle is moved inside by kInward times its clearance. Nothing for degenerate
/// triangles.
inline std::optional<PolarFrame<Mp200>> frame_moved_inward(std::span<const Vec3<Mp200>> corners,
                                                           const Vec3<Mp200>& point) {
  const auto t = lined_triangle(corners, point);
  if (!t) return std::nullopt;
  const OnTriangle on = on_triangle(*t);
  return polar_frame(*t, on.yes ? Mp200(on.clearance * kInward) : Mp200(0));
}

}  // namespace cageproof::quadrature_ref
