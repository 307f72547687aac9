// SPDX-License-Identifier: MIT
#pragma once

#include "polar_frame.h"

namespace cageproof::quadrature_ref {

/// How far inside a point on the triangle is moved where double's range must hold the kernel, in units of its
/// clearance.
inline constexpr double kInward = 1e-16;

/// The exact frame of a query; a point on the triangle is moved inside by kInward. Nothing without geometry.
template <Scalar R>
std::optional<PolarFrame<Mp200>> frame_moved_inward(const Query<R>& query) {
  const auto t = local_triangle(ConvertedQuery<Mp200>(query).query);
  if (!t) return std::nullopt;
  const OnTriangle on = on_triangle(*t);
  return polar_frame(*t, on.yes ? Mp200(on.clearance * kInward) : Mp200(0));
}

}  // namespace cageproof::quadrature_ref
