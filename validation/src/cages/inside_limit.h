// SPDX-License-Identifier: MIT
// Coordinates on the cage against those next to it.
#pragma once

#include "cageproof/validation/cage_points.h"

#include <array>
#include <optional>

namespace cageproof::validation {

/// For each order up to `order` the largest difference, in units of the cage's size, between the coordinates at a point
/// on the cage (hat functions for interpolating kinds) and those 1e-11 sizes inside it, which come from the formulas
/// alone; NaN off the cage. Those of derivatives of order k are multiplied by the (k + 1)th power of the distance to
/// the rest of the cage, in its sizes: derivatives change that much faster next to edges. Derivatives that the
/// coordinates do not have on the cage, NaN or infinite, are not compared. Nothing for orders of which none is left,
/// and for all where the rest of the cage is so near, within 1e-4 sizes, that coordinates change over that step, where
/// the inside overlaps another part, and where it is so sharp that a thousand directions miss it.
std::array<std::optional<double>, 3> inside_limit_errors_at(const CageCoordinates& coordinates, const Cage& cage,
                                                            const CageLocator& locator, const Vec3<double>& point,
                                                            int order);

}  // namespace cageproof::validation
