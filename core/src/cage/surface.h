// SPDX-License-Identifier: MIT
// Surfaces that embedded cages are made of.
#pragma once

#include "cageproof/core/cage/cage.h"

#include <numbers>
#include <string>
#include <utility>
#include <vector>

namespace cageproof {

/// A closed surface in the making; faces are counter-clockwise seen from outside.
struct Surface {
  std::vector<Vec3<double>> vertices;
  std::vector<Face> faces;

  int count() const { return static_cast<int>(vertices.size()); }
  void add(int a, int b, int c, int d = -1) { faces.push_back({{a, b, c, d}}); }
  /// Quads between two rings of n vertices; both run counter-clockwise seen from above.
  void join(int ring, int next_ring, int n) {
    for (int i = 0; i < n; ++i) {
      const int j = (i + 1) % n;
      add(ring + i, ring + j, next_ring + j, next_ring + i);
    }
  }
  /// Four vertices (+-half, +-half, z), counter-clockwise seen from above, turned by `angle` about the z axis; the
  /// first one's number.
  int add_square(double half, double z, double angle = 0);
};

/// A cube's faces, of its corners by the bits x, y, z of their numbers.
inline constexpr int kBoxFaces[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                                        {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};

/// The corners of a cube of size 1 about the origin.
Surface box_corners();

/// A cube of size 1 about the origin.
Surface cube();

/// A regular icosahedron on the unit sphere.
Surface icosahedron();

/// A box open at the top, with walls and a floor of that thickness.
Surface open_box(double wall);

}  // namespace cageproof
