// SPDX-License-Identifier: MIT
// Segments of a polygon that cross or touch each other.
#pragma once

#include "cageproof/core/cage/cage.h"

#include <optional>

namespace cageproof {

/// Two segments, counted from 0, the lower one first, that meet elsewhere than at a vertex that both have.
struct SegmentContact {
  enum class How { Cross, Touch, Overlap };
  int first, second;
  How how;
  int vertex = -1;  ///< Touch: lies within the other segment. Overlap: where a spike turns back, -1 where none does.
};

/// The first pair in rising order, decided exactly (CGAL's predicates); nothing for polygons that are simple.
/// \pre two indices a segment, in range; segments have a length, and no two vertices lie at one place
std::optional<SegmentContact> first_contact(const std::vector<Vec3<double>>& vertices,
                                            const std::vector<Face>& segments);

}  // namespace cageproof
