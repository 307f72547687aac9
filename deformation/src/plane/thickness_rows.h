// SPDX-License-Identifier: MIT
// Rows that measure and hold thickness, which is linear in the posed vertices F and the posed edges' unit normals n'.
#pragma once

#include "thickness.h"

namespace cageproof::deformation {

/// A linear map of F (of_vertices) and n' (of_normals), one row per point of the plane.
template <Scalar R>
struct BoundaryRows {
  Matrix<R> of_vertices, of_normals;

  /// \param vertices F, one row per vertex \param normals n', one row per edge
  Matrix<R> at(const Matrix<R>& vertices, const Matrix<R>& normals) const {
    return of_vertices * vertices + of_normals * normals;
  }
};

/// d^2 f / dn^2 at samples of each edge, limits from inside.
/// \throws InputError where it is infinite
template <Scalar R>
BoundaryRows<R> thickness_rows(const CageCoordinates& coordinates, int samples_an_edge);

/// f at the positions. \throws InputError for those outside the cage
template <Scalar R>
BoundaryRows<R> position_rows(const CageCoordinates& coordinates, const std::vector<Constraints::Position>& positions);

/// The posed edges' unit normals, one row per edge, and their derivatives by F: row 2 e + a, column 2 v + b of
/// `derivative` is that of component a of edge e's by component b of vertex v.
template <Scalar R>
struct NormalsAt {
  Matrix<R> normals, derivative;
};

/// \param from vertices at rest, one row each \param moved what F has more: edges that are short next to their distance
/// from the origin keep their digits so \throws InputError for an edge without length
template <Scalar R>
NormalsAt<R> normals_at(const CageElements& rest, const Matrix<R>& from, const Matrix<R>& moved);

/// The derivative of BoundaryRows::at by F: row 2 r + a, column 2 v + b.
template <Scalar R>
Matrix<R> jacobian(const BoundaryRows<R>& rows, const NormalsAt<R>& normals);

}  // namespace cageproof::deformation
