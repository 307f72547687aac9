// SPDX-License-Identifier: MIT
// Spheres of many faces, made by refining the embedded icosphere of 80 faces.
#pragma once

#include "cageproof/core/cage/embedded_cages.h"

#include <array>
#include <map>
#include <utility>
#include <vector>

namespace cageproof {

// Each face cut in four, with the new vertices on the unit sphere.
inline Cage finer(const Cage& cage) {
  std::vector<Vec3<double>> vertices = cage.vertices();
  for (Vec3<double>& v : vertices) v.normalize();
  std::map<std::pair<int, int>, int> middles;
  const auto middle = [&](int a, int b) {
    const auto [place, added] = middles.try_emplace(std::minmax(a, b), static_cast<int>(vertices.size()));
    if (added) vertices.emplace_back((vertices[a] + vertices[b]).normalized());
    return place->second;
  };
  std::vector<Face> faces;
  faces.reserve(4 * cage.faces().size());
  for (const Face& face : cage.faces()) {
    const auto& [a, b, c, none] = face.vertices;
    const int x = middle(a, b), y = middle(b, c), z = middle(c, a);
    for (const auto& [i, j, k] : {std::array{a, x, z}, {x, b, y}, {z, y, c}, {x, y, z}})
      faces.push_back({{i, j, k, -1}});
  }
  return cage.with(std::move(vertices), std::move(faces));
}

/// \param faces 80, 320, 1280, ...
inline Cage sphere(int faces) {
  Cage cage = embedded_cage("icosphere");
  while (static_cast<int>(cage.faces().size()) < faces) cage = finer(cage);
  return cage;
}

}  // namespace cageproof
