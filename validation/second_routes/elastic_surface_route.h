// SPDX-License-Identifier: MIT
// Elastic coordinates of cages in space ([C23] Sections 3 and 4.2), from Somigliana's identity with layers a hair
// inside of the cage in place of limits, by elimination in 200 digits.
#pragma once

#include "elimination.h"

#include "cageproof/core/cage/cage.h"
#include "cageproof/core/catalogue/evaluation.h"

#include <array>
#include <vector>

namespace cageproof::second_routes {

/// With triangles split in four once, by their edges' midpoints, tractions that are constant on each quarter, and the
/// identity asked to hold at the quarters' centroids; the quarters in the cage's own unit of length.
class ElasticSurfaceRoute {
 public:
  explicit ElasticSurfaceRoute(const Cage& cage);
  /// The matrices of all vertices, row by row.
  std::vector<Mp200> at(const Vec3<double>& point) const;

 private:
  using Corners = std::array<Vec3<Mp50>, 3>;
  using Rows = Table<Mp200>;
  /// Three rows, of a displacement: T of displacements at vertices, and K of tractions on quarters.
  struct Layers {
    Rows of_displacements, of_tractions;
  };
  Layers layers_at(const Vec3<Mp50>& point) const;

  std::size_t vertices_;
  Evaluation displacement_, traction_;
  std::array<Mp50, 2> constants_;            ///< the shear modulus, and Poisson's ratio
  std::vector<std::array<int, 3>> numbers_;  ///< of each triangle's vertices
  std::vector<Corners> triangles_, quarters_;
  Rows tractions_;  ///< of displacements at vertices: three rows per quarter, three columns per vertex
};

}  // namespace cageproof::second_routes
