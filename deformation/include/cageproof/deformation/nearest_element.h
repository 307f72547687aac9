// SPDX-License-Identifier: MIT
// The element of a cage that is nearest to a point.
#pragma once

#include "cageproof/core/cage/cage_elements.h"
#include "cageproof/core/geometry/box.h"

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

 private:
  std::vector<std::vector<Vec3<double>>> corners_;
  std::vector<Box> boxes_;
};

}  // namespace cageproof::deformation
