// SPDX-License-Identifier: MIT
// Whether points are inside a cage, for those who deform meshes that may poke out of it.
#pragma once

#include "cageproof/core/cage_elements.h"
#include "cageproof/core/winding_number.h"

#include <optional>
#include <vector>

namespace cageproof::deformation {

/// Decided exactly; of bilinear quads as their triangles at the first corner lie.
class Inside {
 public:
  explicit Inside(const CageElements& elements) {
    for (std::size_t e = 0; e < elements.count(); ++e) {
      const auto c = elements.corners(e);
      if (c.size() == 2) segments_.push_back({c[0], c[1]});
      else triangles_.push_back({c[0], c[1], c[2]});
      if (c.size() == 4) triangles_.push_back({c[0], c[2], c[3]});
    }
  }
  /// On the cage counts as inside.
  bool holds(const Vec3<double>& point) const {
    const std::optional<int> winding =
        segments_.empty() ? winding_number(triangles_, point) : winding_number(segments_, point);
    return !winding || *winding != 0;
  }

 private:
  std::vector<Triangle<double>> triangles_;
  std::vector<Segment<double>> segments_;
};

}  // namespace cageproof::deformation
