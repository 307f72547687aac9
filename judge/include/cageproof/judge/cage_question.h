// SPDX-License-Identifier: MIT
// A cage and points as foreign code is asked for their coordinates.
#pragma once

#include "cageproof/core/numbers/vector.h"

#include <array>
#include <functional>
#include <vector>

namespace cageproof::judge {

/// A cage of triangles and points in space, as a caller has them.
struct CageQuestion {
  std::vector<Vec3<double>> vertices;
  std::vector<std::array<int, 3>> faces;  ///< counter-clockwise seen from outside
  std::vector<Vec3<double>> points;
};

/// Returns coordinates, [point][coordinate]: first those of all vertices, then those of all faces, for kinds that have
/// these. Empty where the function gives none.
using WholeCageFunction = std::function<std::vector<double>(const CageQuestion&)>;

}  // namespace cageproof::judge
