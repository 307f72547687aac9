// SPDX-License-Identifier: MIT
// Tables of a triangle cage, from exact differences of its vertices.
#pragma once

#include "cageproof/closed_form/batch/tables.h"

#include "tiling.h"

#include "cageproof/core/cage/cage_elements.h"
#include "cageproof/core/numbers/mp.h"

#include <array>
#include <span>
#include <utility>
#include <vector>

namespace cageproof::closed_form::batch {

/// The tables of one face and of its edges, in 200 digits.
struct LongFace {
  FaceTable<Mp200> face;
  std::array<EdgeTable<Mp200>, 3> edge;
};

/// A cage's vertices and triangles in a unit in which the cage's size is about one, with tables in double and in
/// double-double. Triangles without area have none.
class Geometry {
 public:
  /// \pre all elements are triangles
  explicit Geometry(const CageElements& elements);
  /// No cage.
  Geometry() = default;

  /// Some of the faces with their vertices and edges, in the same unit and about the same centre. Whatever neighbours
  /// decide of them is as in the whole.
  /// \param vertices becomes the numbers in the whole of the part's
  Geometry part(std::span<const int> faces, std::vector<int>& vertices) const;

  /// Whether double holds all tables: dividing the vertices by the unit was exact, and triangles have areas.
  bool is_sound() const { return sound_; }
  /// The caller's lengths are these times 2^exponent().
  int exponent() const { return exponent_; }
  CageTables tables() const;
  LongFace long_face(int f) const;
  std::array<double, 3> centre() const { return centre_; }
  /// The radius of a ball about the centre that holds the cage.
  double radius() const { return radius_; }
  int vertices() const { return static_cast<int>(vertex_.size() / 3); }
  int edges() const { return static_cast<int>(edge_.size()); }
  int faces() const { return static_cast<int>(face_.size()); }

 private:
  void find_unit(const CageElements& elements);
  void number_edges();
  void find_reach();
  void find_folds();
  void find_centroids();
  void find_tiles();

  int exponent_ = 0;
  bool sound_ = true;
  std::vector<double> vertex_, reach_;
  std::vector<char> folded_;
  std::vector<std::array<int, 3>> corner_, edge_of_;  // of faces
  std::vector<std::pair<int, int>> ends_;             // of edges
  std::vector<EdgeTable<double>> edge_;
  std::vector<FaceTable<double>> face_;
  std::vector<EdgeTable<TwoDoubles>> fine_edge_;
  std::vector<FaceTable<TwoDoubles>> fine_face_;
  std::vector<double> centroid_, over_square_;  // of faces, as CageTables has them
  Tiling tiling_;
  std::array<double, 3> centre_{};
  double radius_ = 0;
};

}  // namespace cageproof::closed_form::batch
