// SPDX-License-Identifier: MIT
// A cage with faces of different sizes.
#pragma once

#include "cageproof/core/cage/embedded_cages.h"

#include <utility>
#include <vector>

namespace cageproof {

/// An icosahedron of which one face is that much smaller than the others.
inline Cage with_small_face(double size) {
  const Cage cage = embedded_cage("icosphere");
  std::vector<Vec3<double>> vertices = cage.vertices();
  const auto& corners = cage.faces().front().vertices;
  const Vec3<double> middle = (vertices[corners[0]] + vertices[corners[1]] + vertices[corners[2]]) / 3;
  for (int k = 0; k < 3; ++k) vertices[corners[k]] = middle + size * (vertices[corners[k]] - middle);
  return cage.with(std::move(vertices), cage.faces());
}

}  // namespace cageproof
