// SPDX-License-Identifier: MIT
// The volume or area that a mesh encloses.
#pragma once

#include "cageproof/core/vector.h"

#include <array>
#include <span>
#include <vector>

namespace cageproof {

/// How vertices are joined. Keeps references.
struct Joined {
  const std::vector<std::vector<int>>& faces;
  const std::vector<std::array<int, 2>>& segments;
  int dimension;  ///< of space: 3, or 2 for the plane, where faces are flat
};

/// Whether each edge of a face is that of another the other way round, and in the plane each end of a segment the
/// beginning of one. Segments in space enclose nothing and open nothing.
bool is_closed(const Joined& joined);

/// What contents are counted in: so many corner simplices with edges of that length. A cube is six, a square two.
struct ContentUnit {
  double length = 1;
  int simplices = 1;
};

/// In space the volume within faces; in the plane the area within faces, and the area within segments. What is inside
/// out counts as negative.
double content_of(const Joined& joined, std::span<const Vec3<double>> vertices, const ContentUnit& unit);

}  // namespace cageproof
