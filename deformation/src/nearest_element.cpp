// SPDX-License-Identifier: MIT
#include "cageproof/deformation/nearest_element.h"

#include "cageproof/core/geometry/nearest.h"

#include <algorithm>
#include <limits>

namespace cageproof::deformation {

namespace {

std::vector<std::vector<Vec3<double>>> corners_of(const CageElements& elements) {
  std::vector<std::vector<Vec3<double>>> all;
  all.reserve(elements.count());
  for (std::size_t e = 0; e < elements.count(); ++e) all.push_back(elements.corners(e));
  return all;
}

}  // namespace

NearestElements::NearestElements(const CageElements& elements)
    : corners_(corners_of(elements)), tree_(boxes_of(corners_)), normals_(elements.normals()) {}

NearestElement NearestElements::of(const Vec3<double>& point) const {
  NearestElement best{0, Vec3<double>::Zero(), std::numeric_limits<double>::infinity()};
  tree_.by_distance(point, [&](int index) {
    const auto e = static_cast<std::size_t>(index);
    const NearestPlace found = nearest_place(corners_[e], point);
    const double distance = (found.place - point).stableNorm();
    if (distance < best.distance || (distance == best.distance && e < best.element)) best = {e, found.place, distance};
    return best.distance;
  });
  return best;
}

std::vector<Vec3<double>> NearestElements::inwards_at(const NearestElement& nearest, double near) const {
  std::vector<Vec3<double>> ways{Vec3<double>::Zero()};
  const Vec3<double>& place = nearest.place;
  std::vector<int> close;
  tree_.by_distance(place, [&](int e) {
    if ((nearest_place(corners_[e], place).place - place).stableNorm() <= near) close.push_back(e);
    return near;
  });
  std::ranges::sort(close);
  for (const int e : close) {
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
