// SPDX-License-Identifier: MIT
#include "cageproof/deformation/nearest_element.h"

#include "cageproof/core/geometry/nearest.h"

#include <limits>

namespace cageproof::deformation {

NearestElements::NearestElements(const CageElements& elements) : normals_(elements.normals()) {
  for (std::size_t e = 0; e < elements.count(); ++e) {
    corners_.push_back(elements.corners(e));
    boxes_.push_back(box_of(corners_.back()));
  }
}

NearestElement NearestElements::of(const Vec3<double>& point) const {
  NearestElement best{0, Vec3<double>::Zero(), std::numeric_limits<double>::infinity()};
  for (std::size_t e = 0; e < corners_.size(); ++e) {
    const auto& [low, high] = boxes_[e];
    if ((point - point.cwiseMax(low).cwiseMin(high)).stableNorm() > best.distance) continue;
    const NearestPlace found = nearest_place(corners_[e], point);
    const double distance = (found.place - point).stableNorm();
    if (distance < best.distance) best = {e, found.place, distance};
  }
  return best;
}

std::vector<Vec3<double>> NearestElements::inwards_at(const NearestElement& nearest, double near) const {
  std::vector<Vec3<double>> ways{Vec3<double>::Zero()};
  for (std::size_t e = 0; e < corners_.size(); ++e) {
    const auto& [low, high] = boxes_[e];
    const Vec3<double>& place = nearest.place;
    if ((place - place.cwiseMax(low).cwiseMin(high)).stableNorm() > near) continue;
    if ((nearest_place(corners_[e], place).place - place).stableNorm() > near) continue;
    ways.front() -= normals_[e];
    ways.emplace_back(-normals_[e]);
  }
  Vec3<double> centre = Vec3<double>::Zero();
  const auto& corners = corners_[nearest.element];
  for (const Vec3<double>& corner : corners) centre += corner / static_cast<double>(corners.size());
  ways.emplace_back((centre - nearest.place).stableNormalized() - normals_[nearest.element]);
  for (Vec3<double>& way : ways) way.stableNormalize();
  return ways;
}

}  // namespace cageproof::deformation
