// SPDX-License-Identifier: MIT
// The points of a chunk in the order of the plans that they see a face by.
#pragma once

#include "geometry.h"
#include "plans.h"

#include <span>
#include <vector>

namespace cageproof::adaptive_qmvc::batch {

/// Memory for one face after the other.
class PointsByPlan {
 public:
  explicit PointsByPlan(const Plans& plans) : plans_(plans) {}

  /// Sorts points 0 .. count - 1. \param distances [edge][stride], of all points from the edges of the cage
  void sort(const FaceTables& face, const double* distances, int stride, int count);
  /// The points of a plan, or of Plans::none(): those that see the face by no plan, or from no distance that is a
  /// number.
  std::span<const int> by(int plan) const {
    return std::span(order_).subspan(first_[plan], first_[plan + 1] - first_[plan]);
  }

 private:
  const Plans& plans_;
  std::vector<int> plan_, order_, first_;  // of points, the points by plan, where each plan's begin
};

}  // namespace cageproof::adaptive_qmvc::batch
