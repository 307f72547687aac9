// SPDX-License-Identifier: MIT
// Points that lie outside a cage by a rounding, as centroids of slanted faces do, moved to it.
#pragma once

#include "cageproof/deformation/inside.h"

namespace cageproof::deformation {

/// The result of moved_inside.
struct MovedInside {
  std::vector<Vec3<double>> points;  ///< all of them, in their order
  std::size_t count = 0;             ///< that were moved
  double farthest = 0;               ///< the longest way of one
};

/// Moves points that lie outside, by no more than `distance` from the nearest element, to the nearest place of it, or,
/// where rounding leaves that outside, further in, by a rounding of the cage's size first and never by more than
/// `distance`. Others stay where they are. \param distance at least 0 \param jobs threads; 0: all cores
MovedInside moved_inside(const CageElements& elements, const std::vector<Vec3<double>>& points, double distance,
                         int jobs);

}  // namespace cageproof::deformation
