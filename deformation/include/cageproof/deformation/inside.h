// SPDX-License-Identifier: MIT
// Whether points are inside a cage, for those who deform meshes that may poke out of it.
#pragma once

#include "cageproof/core/cage/winding_numbers.h"

namespace cageproof::deformation {

/// Decided exactly, of bilinear quads as of triangles and segments.
class Inside {
 public:
  explicit Inside(const CageElements& elements) : windings_(elements) {}
  /// On the cage counts as inside.
  bool holds(const Vec3<double>& point) const;

 private:
  WindingNumbers windings_;
};

}  // namespace cageproof::deformation
