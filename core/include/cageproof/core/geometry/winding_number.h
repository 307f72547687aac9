// SPDX-License-Identifier: MIT
// How often a closed surface of triangles winds around a point.
#pragma once

#include "cageproof/core/geometry/element.h"

#include <optional>

namespace cageproof {

/// Returns the winding number of a closed, oriented surface around a point: 1 inside a surface whose normals point
/// outward, -1 inside one whose normals point inward, 0 outside, the sum of these where parts overlap, and nothing for
/// a point on one of the triangles. It counts signed crossings of a ray with exact predicates.
/// \pre triangles have an area, and every edge is run along as often in one direction as in the other
std::optional<int> winding_number(std::span<const Triangle<double>> triangles, const Vec3<double>& point);

/// The winding number of closed polygons in the plane: 1 inside those that run counter-clockwise, and nothing for a
/// point on one of the segments.
std::optional<int> winding_number(std::span<const Segment<double>> segments, const Vec3<double>& point);

}  // namespace cageproof
