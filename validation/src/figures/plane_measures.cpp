// SPDX-License-Identifier: MIT
#include "plane_measures.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace cageproof::validation {

std::optional<double> miss_of_cage(const Cage& cage, const std::vector<Vec3<double>>& posed,
                                   const std::vector<Vec3<double>>& points, const std::vector<Vec3<double>>& images) {
  std::optional<double> largest;
  for (std::size_t p = 0; p < points.size(); ++p) {
    double nearest = std::numeric_limits<double>::infinity();
    Vec3<double> place = Vec3<double>::Zero();
    for (const Face& face : cage.faces()) {
      const int first = face.vertices[0], second = face.vertices[1];
      const Vec3<double>&from = cage.vertices()[first], along = cage.vertices()[second] - from;
      const double at = std::clamp((points[p] - from).dot(along) / along.squaredNorm(), 0.0, 1.0);
      const double distance = (points[p] - from - at * along).norm();
      if (distance >= nearest) continue;
      nearest = distance;
      place = (1 - at) * posed[first] + at * posed[second];
    }
    if (nearest <= 1e-5 * cage.size()) largest = std::max(largest.value_or(0), (images[p] - place).norm());
  }
  return largest;
}

double folded_share(const std::vector<std::vector<int>>& faces, const std::vector<Vec3<double>>& images) {
  std::size_t folded = 0, all = 0;
  for (const auto& face : faces)
    for (std::size_t k = 2; k < face.size(); ++k) {
      const Vec3<double>&a = images[face[0]], b = images[face[k - 1]] - a, c = images[face[k]] - a;
      ++all;
      if (b[0] * c[1] - b[1] * c[0] < 0) ++folded;
    }
  return all == 0 ? 0 : static_cast<double>(folded) / static_cast<double>(all);
}

double angle_change(const Vec3<double>& by_x, const Vec3<double>& by_y) {
  // A linear map is the sum of a similarity and one that turns the plane over: (a + b) / 2 and (a - b) / 2 are their
  // factors.
  const double keeps = std::hypot(by_x[0] + by_y[1], by_x[1] - by_y[0]),
               turns = std::hypot(by_x[0] - by_y[1], by_x[1] + by_y[0]);
  if (turns >= keeps) return 180;
  return 2 * std::asin(turns / keeps) * 180 / std::numbers::pi;
}

}  // namespace cageproof::validation
