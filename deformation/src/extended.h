// SPDX-License-Identifier: MIT
// Coordinates of points outside, continued through the element that is nearest (Lipman et al. 2008, "Green
// Coordinates", on the exterior of simple faces).
#pragma once

#include "cageproof/core/coordinates/coordinates.h"
#include "cageproof/deformation/nearest_element.h"

namespace cageproof::deformation {

/// Outside a cage the sum of coordinates times data jumps by what the data are on the element that a point leaves
/// through: f inside minus f outside is the affine map that has the element's values at its vertices and its normal
/// derivative along its normal. Added to f outside, it continues f. So each vertex of the element gets what it weighs
/// in the point's affine combination, and the element its height over the element.
class Extended {
 public:
  /// \pre coordinates.kind().extends
  explicit Extended(const CageCoordinates& coordinates);
  /// Adds the map of the nearest element to row p of the point's tables, derivatives up to `order`, too.
  /// \return the distance from that element
  double add_to(std::vector<CoordinateTable<double>>& tables, std::size_t p, const Vec3<double>& point,
                int order) const;

 private:
  const CageElements& elements_;
  double normal_factor_;
  NearestElements nearest_;
};

}  // namespace cageproof::deformation
