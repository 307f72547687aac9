// SPDX-License-Identifier: MIT
// Coordinates of polygons that solve boundary equations ([W12] Section 4 and Appendix B), from Green's identities with
// layers a hair inside of the cage in place of limits, by normal equations in 200 digits.
#pragma once

#include "elimination.h"

#include "cageproof/core/cage/cage.h"
#include "cageproof/core/catalogue/evaluation.h"

#include <vector>

namespace cageproof::second_routes {

/// With edges in four pieces each, whose ends and midpoints the identities are asked to hold at, in a unit of length in
/// which the largest distance between two vertices is one.
class BoundaryRoute {
 public:
  /// \param order of the equation Laplacian^order f = 0: 1, 2 or 3
  BoundaryRoute(const Cage& cage, int order);
  /// Coordinates of values at vertices, of normal derivatives of edges, of Laplacians at vertices, up to the order.
  std::vector<std::vector<Mp200>> at(const Vec3<double>& point) const;

 private:
  using Matrix = Table<Mp200>;
  /// One row of a layer's order: phi with one column per node, and psi with one column per piece.
  struct Layers {
    std::vector<Matrix> phi, psi;
  };
  Vec3<Mp50> in_frame(const Vec3<double>& point) const;
  Vec3<Mp50> node(std::size_t edge, int k) const;
  std::size_t number_of(std::size_t edge, int k) const;
  Vec3<Mp50> inward(std::size_t edge) const;
  void add_row(const Vec3<Mp50>& point, std::size_t row, Layers& layers) const;
  Layers layers_at(const std::vector<Vec3<Mp50>>& points) const;
  double tau() const;
  void solve();

  const Cage& cage_;
  int order_;
  double unit_ = 0;
  std::vector<Evaluation> of_layers_;
  Matrix from_vertices_, from_edges_;  ///< data at nodes and on pieces
  Matrix slopes_{0, 0};                ///< A: a harmonic function's normal derivatives by its values
  Matrix lower_{0, 0};                 ///< E: by the Laplacian, of a function that is zero
  Matrix highest_{0, 0};               ///< the unknowns, one column per coordinate: the highest Laplacian
};

}  // namespace cageproof::second_routes
