// SPDX-License-Identifier: MIT
// The embedded cages of the plane.
#pragma once

#include "cageproof/core/cage/cage.h"

#include <span>

namespace cageproof {

/// One embedded polygon, by its loops: the first runs counter-clockwise, those that bound holes clockwise.
struct EmbeddedPolygon {
  using Loop = std::vector<Vec3<double>>;
  std::string_view name;
  std::vector<Loop> (*loops)();

  Cage make() const;
};

/// In report order.
std::span<const EmbeddedPolygon> embedded_polygons();

}  // namespace cageproof
