// SPDX-License-Identifier: MIT
// A point just inside a cage, next to one on it.
#pragma once

#include "cageproof/core/coordinates/coordinates.h"
#include "cageproof/validation/cage_points.h"

#include <optional>

namespace cageproof::validation {

/// How far inside, in sizes of the cage.
inline constexpr double inside_step = 1e-11;

/// A point that far inside; nothing where the inside overlaps another part of the cage, or faces cross or touch at
/// the point, or a thousand directions miss it. \param on the elements that the point lies on
std::optional<Vec3<double>> point_inside(const CageCoordinates& coordinates, const Cage& cage,
                                         const CageLocator& locator, const Vec3<double>& point,
                                         const std::vector<Touching>& on);

}  // namespace cageproof::validation
