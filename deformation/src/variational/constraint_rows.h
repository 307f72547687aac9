// SPDX-License-Identifier: MIT
// The linear part of [T24] Eq 37-40: basis functions and their derivatives at the places of constraints.
#pragma once

#include "variational.h"

namespace cageproof::deformation {

/// \throws InputError for weights, steps and tolerances out of range, no constraints, and numbers of constraints that
/// are not finite; in so many dimensions
void check_constraints(const Constraints& constraints, const VariationalOptions& options, int dimension);

/// Rows in the order of positions (one per point), orientations and rotations (one per axis), Hessians (one per pair of
/// axes), times the square roots of their weights. Columns: coefficients of each block in turn. Coordinates that are
/// matrices make all of them as many rows and columns as there are components, one after the other; others serve all
/// components alike.
template <Scalar R>
struct ConstraintRows {
  Matrix<R> matrix;
  int components;  ///< rows and columns of a coordinate
  /// Units of coefficients, which give each the unit of a length: h, 1, 1/h, 1/h^2 for phi, psi, phibar and psibar,
  /// with h the cage's size. Rank and least norm are then the same in any unit of length.
  Eigen::Matrix<R, Eigen::Dynamic, 1> units;
  Eigen::Index orientations, rotations, hessians;  ///< first rows, of one component
  R root_alpha, root_beta;

  /// Tables of one row per row, or coefficient, and one column per component, as the matrix takes them, and back.
  Matrix<R> stacked(const Matrix<R>& table) const {
    return table.transpose().reshaped(table.cols() / components, table.rows() * components).transpose();
  }
  Matrix<R> table(const Matrix<R>& stacked) const {
    return stacked.transpose().reshaped(stacked.cols() * components, stacked.rows() / components).transpose();
  }
};

/// \param size of the cage \throws InputError for points outside the cage, or where derivatives do not exist
template <Scalar R>
ConstraintRows<R> constraint_rows(const CageCoordinates& coordinates, const Constraints& constraints,
                                  const VariationalOptions& options, double size);

}  // namespace cageproof::deformation
