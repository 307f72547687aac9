// SPDX-License-Identifier: MIT
#include "cageproof/core/cage/face_triangles.h"

#include "ears.h"
#include "face_pieces.h"

namespace cageproof {

std::vector<std::array<int, 3>> triangles_of_face(std::span<const Vec3<double>> corners) {
  if (corners.size() == 3) return {{0, 1, 2}};
  if (corners.size() > 4) return ears_of(corners);
  const auto& triangles =
      split_of({corners.begin(), corners.end()}, Face{{0, 1, 2, 3}}, Triangulation::Shortest).triangles;
  return {triangles.begin(), triangles.end()};
}

}  // namespace cageproof
