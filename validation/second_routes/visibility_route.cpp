// SPDX-License-Identifier: MIT
#include "visibility_route.h"

#include "cageproof/core/numbers/linear.h"

#include <array>
#include <cmath>
#include <limits>

namespace cageproof::second_routes {
namespace {

using Place3 = Vec3<double>;

// Where a ray meets a triangle, by Moller and Trumbore: distance and two hat functions.
struct Hit {
  double distance = std::numeric_limits<double>::infinity();
  std::array<double, 3> hats{};
  std::size_t triangle = 0;
};

Hit hit_of(const std::array<Place3, 3>& corners, const Place3& direction) {
  const Place3 e1 = corners[1] - corners[0], e2 = corners[2] - corners[0], across = direction.cross(e2);
  const double determinant = e1.dot(across);
  if (determinant == 0) return {};
  const Place3 from = -corners[0];
  const double u = from.dot(across) / determinant;
  if (u < 0 || u > 1) return {};
  const Place3 turned = from.cross(e1);
  const double v = direction.dot(turned) / determinant;
  if (v < 0 || u + v > 1) return {};
  const double distance = e2.dot(turned) / determinant;
  if (!(distance > 0)) return {};
  return {distance, {1 - u - v, u, v}, 0};
}

}  // namespace

std::vector<double> coordinates_of_rays(const Cage& cage, const Vec3<double>& point) {
  const auto triangles = cage.triangulate(Triangulation::Shortest).triangles;
  std::vector<std::array<Place3, 3>> corners;
  corners.reserve(triangles.size());
  for (const auto& t : triangles)
    corners.push_back({cage.vertices()[t[0]] - point, cage.vertices()[t[1]] - point, cage.vertices()[t[2]] - point});
  std::vector<double> found(cage.vertices().size(), 0.0);
  double sum = 0;
  for (int face = 0; face < 6; ++face)
    for (int i = 0; i < rays_per_side; ++i)
      for (int j = 0; j < rays_per_side; ++j) {
        Place3 d;
        d[face % 3] = face < 3 ? 1 : -1;
        d[(face + 1) % 3] = (2 * i + 1.) / rays_per_side - 1;
        d[(face + 2) % 3] = (2 * j + 1.) / rays_per_side - 1;
        const double length = d.norm();
        Hit first;
        for (std::size_t t = 0; t < triangles.size(); ++t) {
          Hit hit = hit_of(corners[t], d / length);
          hit.triangle = t;
          if (hit.distance < first.distance) first = hit;
        }
        if (std::isinf(first.distance)) continue;  // through an edge but for rounding
        const double weight = 1 / (length * length * length * first.distance);
        for (int k = 0; k < 3; ++k) found[triangles[first.triangle][k]] += weight * first.hats[k];
        sum += weight;
      }
  for (double& x : found) x /= sum;
  return found;
}

}  // namespace cageproof::second_routes
