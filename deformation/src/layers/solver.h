// SPDX-License-Identifier: MIT
// Least squares by a rank-revealing orthogonal factorisation.
#pragma once

#include "cageproof/deformation/deformer.h"

#include <Eigen/QR>

#include <string>

namespace cageproof::deformation {

/// A matrix factored once, for right sides that come one after the other. Columns that others give to 1e-13 count as
/// dependent, in every scalar alike.
template <Scalar R>
class Factored {
 public:
  explicit Factored(Matrix<R> matrix);

  const Matrix<R>& matrix() const { return matrix_; }
  Eigen::Index rank() const { return factors_.rank(); }
  /// Of least residual, and of least norm among those.
  Matrix<R> solve(const Matrix<R>& right) const { return factors_.solve(right); }
  /// What there is to say of a solution. The condition is that of the factorisation's triangle, from its singular
  /// values.
  SolvedSystem described(std::string name, const Matrix<R>& right, const Matrix<R>& solution) const;

 private:
  Matrix<R> matrix_;
  Eigen::CompleteOrthogonalDecomposition<Matrix<R>> factors_;
};

/// The solution of least residual and least norm of matrix x solution = right, by Factored.
/// \param solved where what was solved is described; null where nobody asks
template <Scalar R>
Matrix<R> least_squares(const Matrix<R>& matrix, const Matrix<R>& right, std::string name,
                        std::vector<SolvedSystem>* solved);

}  // namespace cageproof::deformation
