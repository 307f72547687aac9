// SPDX-License-Identifier: MIT
// Tables of a cage of quads and triangles, from exact differences of its vertices.
#pragma once

#include "tables.h"

#include "cageproof/core/cage/cage_elements.h"

#include <array>
#include <vector>

namespace cageproof::adaptive_qmvc::batch {

/// One face as kernels see it: a quad, or a triangle whose last two corners are one.
struct FaceTables {
  QuadTable along, turned;  ///< lines along the sides from corner 0 to corner 1, and from 0 to 3
  std::array<int, 4> edge;  ///< from corner i to corner i + 1
  double over_u, over_v;    ///< one over the longer one of edges 0 and 2, and of 1 and 3
};

/// A cage's vertices and faces in a unit in which the cage's size is about one.
class Geometry {
 public:
  explicit Geometry(const CageElements& elements);

  /// Whether the cage has a size, and each face sides both ways.
  bool is_sound() const { return sound_; }
  /// The caller's lengths are these times 2^exponent().
  int exponent() const { return exponent_; }
  int vertices() const { return static_cast<int>(vertex_.size()); }
  const std::vector<FaceTables>& faces() const { return faces_; }
  const std::vector<EdgeTable>& edges() const { return edges_; }

 private:
  void find_unit(const CageElements& elements);
  int edge_between(int from, int to);
  void add_face(std::array<int, 4> corners);

  int exponent_ = 0;
  bool sound_ = true;
  std::vector<Vec3<double>> vertex_;
  std::vector<EdgeTable> edges_;
  std::vector<FaceTables> faces_;
};

}  // namespace cageproof::adaptive_qmvc::batch
