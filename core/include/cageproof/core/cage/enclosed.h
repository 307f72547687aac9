// SPDX-License-Identifier: MIT
// The volume or area that a mesh encloses.
#pragma once

#include "cageproof/core/numbers/vector.h"

#include <array>
#include <cmath>
#include <span>
#include <vector>

namespace cageproof {

/// The faces and segments that connect vertices. Keeps references.
struct Connectivity {
  const std::vector<std::vector<int>>& faces;
  const std::vector<std::array<int, 2>>& segments;
  int dimension;  ///< of space: 3, or 2 for the plane, where faces are flat
};

/// Whether each edge of a face is that of another the other way round, and in the plane each end of a segment the
/// beginning of one. Segments in space enclose nothing and open nothing.
bool is_closed(const Connectivity& connectivity);

/// The unit of contents: so many corner simplices with edges of that length. A cube is six, a square two.
struct ContentUnit {
  double length = 1;
  int simplices = 1;
};

/// A volume, or in the plane an area; negative where it is inside out.
struct Content {
  double value = 0;
  double rounding = 0;  ///< at most so much of it is rounding of the sum
  /// False where parts that are turned against each other cancel.
  bool is_known() const { return std::abs(value) > rounding; }
};

/// In space the volume within faces; in the plane the area within faces, and the area within segments. Quads are
/// bilinear: their volume is the mean of those that either diagonal makes. Other polygons are fans.
Content content_of(const Connectivity& connectivity, std::span<const Vec3<double>> vertices, const ContentUnit& unit);

}  // namespace cageproof
