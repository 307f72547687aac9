// SPDX-License-Identifier: MIT
// The element of a cage that is nearest to a point.
#pragma once

#include "cageproof/core/cage/cage_elements.h"
#include "cageproof/core/geometry/box_tree.h"

#include <vector>

namespace cageproof::deformation {

/// An element, and its place that is nearest to a point.
struct NearestElement {
  std::size_t element;
  Vec3<double> place;
  double distance;
};

/// All elements of a cage, asked for the nearest one. Safe from any thread.
class NearestElements {
 public:
  explicit NearestElements(const CageElements& elements);
  /// The first of several that are as near. In double (core's nearest_place).
  NearestElement of(const Vec3<double>& point) const;
  /// Directions that may lead from a place of the surface to its inside, of length one, the likeliest first: against
  /// the mean normal of the elements within `near` of the place, against each one's, and from the place to the nearest
  /// element's centre and against its normal in equal parts.
  std::vector<Vec3<double>> inwards_at(const NearestElement& nearest, double near) const;

 private:
  std::vector<std::vector<Vec3<double>>> corners_;
  BoxTree tree_;
  std::vector<Vec3<double>> normals_;
};

}  // namespace cageproof::deformation
