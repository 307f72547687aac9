// SPDX-License-Identifier: MIT
// The common part of the boundary equations of biharmonic and triharmonic functions.
#pragma once

#include "collocation.h"

namespace cageproof::solved {

/// The layers at collocation points, and what a harmonic function's normal derivative is of the function itself, as
/// Eq 14 of [W12] says of the highest Laplacian: k = A l.
template <Scalar R>
struct PolyharmonicEquations {
  /// \param collocation its number in collocations() \param inset as BoundaryLayers::rows
  PolyharmonicEquations(const RefinedPolygon& polygon, const BoundaryLayers<R>& layers, double collocation,
                        double inset)
      : PolyharmonicEquations(polygon, layers, collocations()[static_cast<std::size_t>(collocation)], inset) {}

  LayerRows<R> laplacian, value;  ///< where Laplacians' equations are asked to hold, and where that of values is
  LeastSquares<R> single;         ///< psi_1 there
  Matrix<R> right;                ///< H - phi_1 there
  Matrix<R> slopes;               ///< A = pinv(psi_1) (H - phi_1), pieces x nodes
  Matrix<R> biharmonic;           ///< K_2 = phi_2 + psi_2 A where values are
  Matrix<R> nodes;                ///< U_f, nodes x vertices
  /// The right sides from values at vertices and normal derivatives of edges, in the equations of values: (H - phi_1)
  /// U_f next to -psi_1 U_d.
  Matrix<R> data;

  SolvedSystem described(std::string name) const {
    return describe<R>(std::move(name), laplacian[Layer::Single], single.rank(), right, slopes);
  }

 private:
  PolyharmonicEquations(const RefinedPolygon& polygon, const BoundaryLayers<R>& layers, const Collocation& where,
                        double inset)
      : laplacian(layers.rows(points_on(polygon, where.of_laplacians), inset)),
        value(layers.rows(points_on(polygon, where.of_value), inset)),
        single(laplacian[Layer::Single]),
        right(laplacian.hats - laplacian[Layer::Double]),
        slopes(single.solve(right)),
        biharmonic(value[Layer::BiharmonicDouble] + value[Layer::BiharmonicSingle] * slopes),
        nodes(nodes_from_vertices<R>(polygon)),
        data(biharmonic.rows(), polygon.vertices() + polygon.edges()) {
    data << (value.hats - value[Layer::Double]) * nodes, -value[Layer::Single] * pieces_from_edges<R>(polygon);
  }
};

}  // namespace cageproof::solved
