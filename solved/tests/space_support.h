// SPDX-License-Identifier: MIT
// Cages in space for solved coordinates, and points inside.
#pragma once

#include "support.h"

#include <functional>
#include <map>

namespace cageproof::solved::test {

inline CageCoordinates harmonic_at_level(const Cage& cage, int level) {
  return coordinates(cage, "harmonic", {4, 1, static_cast<double>(level)});
}

/// Points of a grid through the cage's box that lie inside, a thousandth of its size or more: n a side.
inline std::vector<Vec> inner_points(const CageElements& elements, int n) {
  Vec low = elements.vertices()[0], high = low;
  for (const Vec& v : elements.vertices()) {
    low = low.cwiseMin(v);
    high = high.cwiseMax(v);
  }
  // By the solid angles of its triangles (Van Oosterom and Strackee).
  const auto inside = [&](const Vec& p) {
    double angle = 0, near = HUGE_VAL;
    for (std::size_t e = 0; e < elements.count(); ++e) {
      const auto c = elements.corners(e);
      const Vec x = c[0] - p, y = c[1] - p, z = c[2] - p;
      near = std::min(near, std::abs(x.dot(elements.normals()[e])));
      angle += 2 * std::atan2(x.dot(y.cross(z)), x.norm() * y.norm() * z.norm() + x.dot(y) * z.norm() +
                                                     y.dot(z) * x.norm() + z.dot(x) * y.norm());
    }
    return angle > 6 && near > 1e-3 * (high - low).norm();
  };
  std::vector<Vec> found;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j)
      for (int k = 0; k < n; ++k) {
        const Vec share((i + 0.43) / n, (j + 0.57) / n, (k + 0.38) / n);
        const Vec p = low + (high - low).cwiseProduct(share);
        if (inside(p)) found.push_back(p);
      }
  return found;
}

/// Each triangle of the cage in four, so many times; its quads as triangles first.
inline Cage split_cage(const Cage& cage, int times) {
  std::vector<Vec> vertices = cage.vertices();
  std::vector<Face> faces = cage.parts(false, Triangulation::Shortest).elements;
  for (int time = 0; time < times; ++time) {
    std::map<std::pair<int, int>, int> middles;
    const auto middle = [&](int a, int b) {
      const auto [at, is_new] = middles.try_emplace(std::minmax(a, b), static_cast<int>(vertices.size()));
      if (is_new) vertices.push_back((vertices[a] + vertices[b]) / 2);
      return at->second;
    };
    std::vector<Face> finer;
    for (const Face& f : faces) {
      const auto [a, b, c, none] = f.vertices;
      const int ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
      for (const std::array<int, 3>& t :
           {std::array{a, ab, ca}, std::array{ab, b, bc}, std::array{ca, bc, c}, std::array{ab, bc, ca}})
        finer.push_back({{t[0], t[1], t[2], -1}});
    }
    faces = std::move(finer);
  }
  return Cage::make("split", vertices, faces);
}

}  // namespace cageproof::solved::test
