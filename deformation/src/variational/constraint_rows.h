// SPDX-License-Identifier: MIT
// The linear part of [T24] Eq 37-40: basis functions and their derivatives at the places of constraints.
#pragma once

#include "variational.h"

namespace cageproof::deformation {

/// \throws InputError for weights, steps and tolerances out of range, no constraints, and numbers of constraints that
/// are not finite; in so many dimensions
void check_constraints(const Constraints& constraints, const VariationalOptions& options, int dimension);

/// Rows in the order of positions (one a point), orientations and rotations (one an axis), Hessians (one a pair of
/// axes), times the square roots of their weights. Columns: coefficients of each block in turn.
template <Scalar R>
struct ConstraintRows {
  Matrix<R> matrix;
  /// Units of coefficients, which give each the unit of a length: h, 1, 1/h, 1/h^2 for phi, psi, phibar and psibar,
  /// with h the cage's size. Rank and least norm are then the same in any unit of length.
  Eigen::Matrix<R, Eigen::Dynamic, 1> units;
  Eigen::Index orientations, rotations, hessians;  ///< first rows
  R root_alpha, root_beta;
};

/// \param size of the cage \throws InputError for points outside the cage, or where derivatives do not exist
template <Scalar R>
ConstraintRows<R> constraint_rows(const CageCoordinates& coordinates, const Constraints& constraints,
                                  const VariationalOptions& options, double size);

}  // namespace cageproof::deformation
