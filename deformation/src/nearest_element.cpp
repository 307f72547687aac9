// SPDX-License-Identifier: MIT
#include "cageproof/deformation/nearest_element.h"

#include "cageproof/core/geometry/nearest.h"

#include <limits>

namespace cageproof::deformation {

NearestElements::NearestElements(const CageElements& elements) {
  for (std::size_t e = 0; e < elements.count(); ++e) {
    corners_.push_back(elements.corners(e));
    boxes_.push_back(box_of(corners_.back()));
  }
}

NearestElement NearestElements::of(const Vec3<double>& point) const {
  NearestElement best{0, Vec3<double>::Zero(), std::numeric_limits<double>::infinity()};
  for (std::size_t e = 0; e < corners_.size(); ++e) {
    const auto& [low, high] = boxes_[e];
    if ((point - point.cwiseMax(low).cwiseMin(high)).norm() > best.distance) continue;
    const NearestPlace found = nearest_place(corners_[e], point);
    const double distance = (found.place - point).norm();
    if (distance < best.distance) best = {e, found.place, distance};
  }
  return best;
}

}  // namespace cageproof::deformation
