// SPDX-License-Identifier: MIT
// Polygons of any number of corners, cut in triangles.
#pragma once

#include "cageproof/core/numbers/vector.h"

#include <array>
#include <span>
#include <vector>

namespace cageproof {

/// The triangles of a polygon in space, by corner, turned as it is: ears of the shortest diagonal first, decided
/// exactly as seen along the coordinate axis that its area is largest on. Corners may lie on a line with their
/// neighbours. \param corners three or more, finite \returns nothing where the polygon, seen so, crosses or touches
/// itself or has no area
std::vector<std::array<int, 3>> ears_of(std::span<const Vec3<double>> corners);

}  // namespace cageproof
