// SPDX-License-Identifier: MIT
// Polygons that solvers are tried on.
#pragma once

#include "cageproof/core/cage/cage.h"

#include <cmath>
#include <numbers>

namespace cageproof::solved::goursat {

/// A polygon through points, in their order.
inline Cage polygon(const char* name, const std::vector<std::array<double, 2>>& points) {
  std::vector<Vec3<double>> vertices;
  std::vector<Face> segments;
  const int n = static_cast<int>(points.size());
  for (int k = 0; k < n; ++k) {
    vertices.emplace_back(points[k][0], points[k][1], 0);
    segments.push_back({{k, (k + 1) % n, -1, -1}});
  }
  return Cage::make_polygon(name, vertices, segments);
}

inline Cage unit_square() { return polygon("unit square", {{0, 0}, {1, 0}, {1, 1}, {0, 1}}); }
inline Cage triangle() { return polygon("triangle", {{0, 0}, {1, 0}, {0.3, 0.8}}); }
inline Cage pentagon() { return polygon("pentagon", {{0, 0}, {2, -0.3}, {2.6, 1.1}, {1.1, 2.2}, {-0.4, 1.2}}); }
inline Cage rectangle() { return polygon("rectangle", {{0, 0}, {10, 0}, {10, 1}, {0, 1}}); }
inline Cage l_shape() { return polygon("L", {{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}}); }
inline Cage five_pointed_star() {
  std::vector<std::array<double, 2>> points;
  for (int k = 0; k < 10; ++k) {
    const double radius = k % 2 == 0 ? 1 : 0.45, angle = std::numbers::pi * k / 5;
    points.push_back({radius * std::cos(angle), radius * std::sin(angle)});
  }
  return polygon("star", points);
}
inline std::vector<Cage> convex_polygons() { return {unit_square(), triangle(), pentagon(), rectangle()}; }

/// The distance to the nearest edge.
inline double distance_to_boundary(const Cage& cage, const Vec3<double>& point) {
  double nearest = HUGE_VAL;
  for (const Face& f : cage.faces()) {
    const Vec3<double> a = cage.vertices()[f.vertices[0]], e = cage.vertices()[f.vertices[1]] - a;
    const double t = std::clamp((point - a).dot(e) / e.squaredNorm(), 0.0, 1.0);
    nearest = std::min(nearest, (point - a - t * e).norm());
  }
  return nearest;
}

/// Points of a grid within the polygon, at least a share of its size from the boundary.
/// \param inside whether a point lies within
template <class Inside>
std::vector<Vec3<double>> points_within(const Cage& cage, double least, int side, Inside inside) {
  Vec3<double> low = cage.vertices().front(), high = low;
  for (const Vec3<double>& v : cage.vertices()) {
    low = low.cwiseMin(v);
    high = high.cwiseMax(v);
  }
  std::vector<Vec3<double>> found;
  for (int i = 1; i < side; ++i)
    for (int j = 1; j < side; ++j) {
      const Vec3<double> p(low[0] + i * (high[0] - low[0]) / side, low[1] + j * (high[1] - low[1]) / side, 0);
      if (inside(p) && distance_to_boundary(cage, p) >= least * cage.size()) found.push_back(p);
    }
  return found;
}

}  // namespace cageproof::solved::goursat
