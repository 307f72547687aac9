// SPDX-License-Identifier: MIT
// Elastic coordinates of polygons ([C23] Sections 3 and 4.2), from Somigliana's identity with layers a hair inside of
// the cage in place of limits, by normal equations in 200 digits.
#pragma once

#include "elimination.h"

#include "cageproof/core/cage/cage.h"
#include "cageproof/core/catalogue/evaluation.h"

#include <vector>

namespace cageproof::second_routes {

/// With edges in four pieces each, whose ends and midpoints the identity is asked to hold at, in a unit of length in
/// which the largest distance between two vertices is one.
class ElasticRoute {
 public:
  explicit ElasticRoute(const Cage& cage);
  /// The matrices of all vertices, row by row.
  std::vector<Mp200> at(const Vec3<double>& point) const;

 private:
  using Matrix = Table<Mp200>;
  /// T of displacements at vertices and K of tractions on pieces, two rows per point.
  struct Layers {
    Matrix of_displacements, of_tractions;
  };
  Vec3<Mp50> vertex(int v) const;
  Vec3<Mp50> node(std::size_t edge, int k) const;
  Vec3<Mp50> inward(std::size_t edge) const;
  Layers layers_at(const std::vector<Vec3<Mp50>>& points) const;

  const Cage& cage_;
  double unit_ = 0;
  Evaluation displacement_, traction_;
  Matrix tractions_{0, 0};  ///< of displacements at vertices
};

}  // namespace cageproof::second_routes
