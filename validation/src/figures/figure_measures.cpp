// SPDX-License-Identifier: MIT
#include "figure_measures.h"

#include <algorithm>
#include <array>
#include <map>
#include <stdexcept>

namespace cageproof::validation {

double asymmetry(const std::vector<Vec3<double>>& points, const std::vector<Vec3<double>>& images) {
  std::map<std::array<double, 3>, std::size_t> at;
  // Zero and its negative are one key.
  const auto key = [](double x, double y, double z) { return std::array{x + 0.0, y + 0.0, z + 0.0}; };
  for (std::size_t p = 0; p < points.size(); ++p) at[key(points[p][0], points[p][1], points[p][2])] = p;
  double found = 0;
  for (std::size_t p = 0; p < points.size(); ++p) {
    const auto mirrored = at.find(key(-points[p][0], points[p][1], points[p][2]));
    if (mirrored == at.end()) throw std::invalid_argument("the points are not symmetric");
    const Vec3<double> image = images[p].cwiseProduct(Vec3<double>(-1, 1, 1));
    found = std::max(found, (images[mirrored->second] - image).norm());
  }
  return found;
}

}  // namespace cageproof::validation
