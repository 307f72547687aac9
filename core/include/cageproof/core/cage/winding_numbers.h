// SPDX-License-Identifier: MIT
// How often one closed boundary winds around each of many points.
#pragma once

#include "cageproof/core/cage/cage_elements.h"
#include "cageproof/core/geometry/box_tree.h"

#include <optional>

namespace cageproof {

/// Winding numbers of a cage, exact: signed crossings of a ray along an axis, of the elements that a tree finds above
/// the point. A point counts as moved to one side by less than any distance, so that no ray meets an edge. Elements are
/// bilinear quads, triangles or segments. Keeps copies; safe from any thread.
class WindingNumbers {
 public:
  explicit WindingNumbers(const CageElements& elements);
  /// Returns 1 inside a surface whose normals point outward, 0 outside, -1 inside one whose normals point inward, the
  /// sum of these where parts overlap, and nothing on the cage.
  std::optional<int> around(const Vec3<double>& point) const;

 private:
  using Corners = std::vector<Vec3<double>>;
  // Coordinates are turned so that the ray is along the last axis, in the plane along the second.
  int first_axis_;
  double top_;
  std::vector<Corners> elements_;
  BoxTree tree_;
};

}  // namespace cageproof
