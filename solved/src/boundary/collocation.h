// SPDX-License-Identifier: MIT
// Where boundary equations are asked to hold: the ways to refine of [W12] Section 4.3.
#pragma once

#include "boundary_layers.h"

#include <string_view>
#include <vector>

namespace cageproof::solved {

/// Points of every piece, which is divided into `parts` equal parts: the beginnings of part k, for each k in `taken`.
struct PiecePoints {
  int parts;
  std::vector<int> taken;
};

/// Where the equations of polyharmonic functions are asked to hold, a way to refine and its name: those of Laplacians
/// (Eq 14 of [W12]), and the one of values (Eq 13).
struct Collocation {
  std::string_view name;
  PiecePoints of_laplacians, of_value;
};

/// All ways; the second is the default.
const std::vector<Collocation>& collocations();

/// The points of all pieces.
std::vector<CollocationPoint> points_on(const RefinedPolygon& polygon, const PiecePoints& of_piece);

/// Linear interpolation of values at vertices to nodes (nodes x vertices): U_f.
template <Scalar R>
Matrix<R> nodes_from_vertices(const RefinedPolygon& polygon) {
  Matrix<R> from = Matrix<R>::Zero(polygon.nodes(), polygon.vertices());
  const int pieces = polygon.pieces_an_edge();
  for (int e = 0; e < polygon.edges(); ++e)
    for (int k = 0; k < pieces; ++k) {
      const int node = polygon.node(e, k);
      from(node, polygon.edge(e)[0]) = R(pieces - k) / pieces;
      if (k > 0) from(node, polygon.edge(e)[1]) = R(k) / pieces;
    }
  return from;
}

/// Values of edges copied to their pieces (pieces x edges): U_d.
template <Scalar R>
Matrix<R> pieces_from_edges(const RefinedPolygon& polygon) {
  Matrix<R> from = Matrix<R>::Zero(polygon.pieces(), polygon.edges());
  for (int p = 0; p < polygon.pieces(); ++p) from(p, p / polygon.pieces_an_edge()) = 1;
  return from;
}

}  // namespace cageproof::solved
