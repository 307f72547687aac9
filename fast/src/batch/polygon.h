// SPDX-License-Identifier: MIT
// Tables of a polygon, from exact differences of its vertices.
#pragma once

#include "plane_tables.h"

#include "cageproof/core/cage/cage_elements.h"

#include <array>
#include <vector>

namespace cageproof::closed_form::batch {

/// A polygon's vertices and edges in a unit in which its size is about one.
class Polygon {
 public:
  /// \pre all elements are segments
  explicit Polygon(const CageElements& elements);

  /// Whether double holds all tables: dividing the vertices by the unit was exact, and edges have lengths.
  bool is_sound() const { return sound_; }
  /// The caller's lengths are these times 2^exponent().
  int exponent() const { return exponent_; }
  PolygonTables tables() const;

 private:
  int exponent_ = 0;
  bool sound_ = true;
  std::vector<double> vertex_;
  std::vector<SideTable> side_;
};

}  // namespace cageproof::closed_form::batch
