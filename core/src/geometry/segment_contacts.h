// SPDX-License-Identifier: MIT
// Segments of polygons that cross or touch each other.
#pragma once

#include "cageproof/core/cage/cage.h"

#include <optional>

namespace cageproof {

/// The way that a polygon takes through a place.
struct Passage {
  Vec3<double> before, at, after;
};
/// Whether one looks to the left of that way from its place, exactly. \pre `towards` lies in the direction of neither
/// `before` nor `after`
bool is_left(const Passage& way, const Vec3<double>& towards);

/// The ways of polygons through their vertices. \pre segments follow each other in loops
class Passages {
 public:
  Passages(const std::vector<Vec3<double>>& vertices, const std::vector<Face>& segments);
  Passage at(int vertex) const { return {vertices_[before_[vertex]], vertices_[vertex], vertices_[after_[vertex]]}; }
  /// A vertex's loop: the first vertex of it.
  int loop(int vertex) const { return loops_[vertex]; }

 private:
  const std::vector<Vec3<double>>& vertices_;
  std::vector<int> before_, after_, loops_;
};

/// Two segments, counted from 0, the lower one first, that meet elsewhere than at a vertex that both have.
struct SegmentContact {
  enum class How { Cross, Touch, Overlap };
  int first, second;
  How how;
  int vertex = -1;  ///< Touch: lies within the other segment. Overlap: where a spike turns back, -1 where none does.
};

/// The first pair in rising order, decided exactly (CGAL's predicates); nothing for polygons that are simple. Polygons
/// may touch others in points, where they do not cross.
/// \pre segments have a length and follow each other in loops; no two vertices of a loop lie at one place
std::optional<SegmentContact> first_contact(const std::vector<Vec3<double>>& vertices,
                                            const std::vector<Face>& segments);

}  // namespace cageproof
