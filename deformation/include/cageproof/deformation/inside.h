// SPDX-License-Identifier: MIT
// Whether points are inside a cage, for those who deform meshes that may poke out of it.
#pragma once

#include "cageproof/core/cage/cage_elements.h"

#include <vector>

namespace cageproof::deformation {

/// Decided exactly, of bilinear quads as of triangles and segments.
class Inside {
 public:
  explicit Inside(const CageElements& elements);
  /// On the cage counts as inside.
  bool holds(const Vec3<double>& point) const;

 private:
  std::vector<Segment<double>> segments_;
  std::vector<Triangle<double>> triangles_;
  std::vector<Quad<double>> quads_;
};

}  // namespace cageproof::deformation
