// SPDX-License-Identifier: MIT
// A cage and points as foreign code is asked for their coordinates.
#pragma once

#include "cageproof/core/cage/cage.h"

#include <functional>
#include <vector>

namespace cageproof::judge {

/// A cage and points, as a caller has them: triangles in space, for kinds that keep them also quads, or segments in the
/// plane.
struct CageRequest {
  std::vector<Vec3<double>> vertices;  ///< in the plane with third coordinate zero
  std::vector<Face> faces;
  std::vector<Vec3<double>> points;
  int dimension = 3;  ///< 2 in the plane

  /// The cage. \throws InputError as Cage::make and Cage::make_polygon
  Cage cage() const;
};

/// Returns coordinates, [point][coordinate]: first those of all vertices, then those of all faces, for kinds that have
/// these. Empty where the function gives none.
using WholeCageFunction = std::function<std::vector<double>(const CageRequest&)>;

}  // namespace cageproof::judge
