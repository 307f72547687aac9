// SPDX-License-Identifier: MIT
#include "figure_measures.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
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

namespace {

// Between a face's normals in two of its edges' order: twice its area along its normal.
Vec3<double> area_vector(const std::vector<int>& face, const std::vector<Vec3<double>>& at) {
  Vec3<double> sum = Vec3<double>::Zero();
  for (std::size_t k = 2; k < face.size(); ++k) sum += (at[face[k - 1]] - at[face[0]]).cross(at[face[k]] - at[face[0]]);
  return sum;
}

double degrees_between(const Vec3<double>& a, const Vec3<double>& b) {
  if (!(a.norm() > 0) || !(b.norm() > 0)) return 180;
  return std::atan2(a.cross(b).norm(), a.dot(b)) * 180 / std::numbers::pi;
}

}  // namespace

double largest_distance(const std::vector<Vec3<double>>& images, const std::vector<Vec3<double>>& others) {
  double found = 0;
  for (std::size_t p = 0; p < images.size(); ++p) found = std::max(found, (images[p] - others[p]).norm());
  return found;
}

double added_turn(const std::vector<std::vector<int>>& faces, const std::vector<Vec3<double>>& points,
                  const std::vector<Vec3<double>>& images) {
  std::map<std::pair<int, int>, std::size_t> first;
  double found = 0;
  for (std::size_t f = 0; f < faces.size(); ++f)
    for (std::size_t k = 0; k < faces[f].size(); ++k) {
      const auto [edge, is_new] = first.try_emplace(std::minmax(faces[f][k], faces[f][(k + 1) % faces[f].size()]), f);
      if (is_new) continue;
      const auto turn = [&](const std::vector<Vec3<double>>& at) {
        return degrees_between(area_vector(faces[f], at), area_vector(faces[edge->second], at));
      };
      found = std::max(found, turn(images) - turn(points));
    }
  return found;
}

std::vector<double> shares_of_step(const std::vector<Vec3<double>>& points, const std::vector<Vec3<double>>& images,
                                   const Vec3<double>& step) {
  std::vector<double> shares;
  shares.reserve(points.size());
  for (std::size_t p = 0; p < points.size(); ++p)
    shares.push_back((images[p] - points[p]).dot(step) / step.squaredNorm());
  return shares;
}

}  // namespace cageproof::validation
