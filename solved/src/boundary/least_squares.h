// SPDX-License-Identifier: MIT
// Linear systems with at least as many equations as unknowns, solved with a factorisation that finds their rank.
#pragma once

#include "boundary_layers.h"

#include <memory>

namespace cageproof::solved {

/// A matrix, factorised (complete orthogonal decomposition): what solve gives is the pseudo-inverse's, the least of the
/// solutions that leave least. Columns that others give to 1e-13 count as dependent, in every scalar alike, so that
/// double and multiprecision solve the same problem.
template <Scalar R>
class LeastSquares {
 public:
  explicit LeastSquares(const Matrix<R>& matrix);
  ~LeastSquares();
  LeastSquares(const LeastSquares&) = delete;
  LeastSquares& operator=(const LeastSquares&) = delete;

  int rank() const;
  Matrix<R> solve(const Matrix<R>& right) const;
  /// The pseudo-inverse. Its own error is common to all columns of right sides: where combinations of these vanish,
  /// those of its products with them do, but for the roundings of the products, which are larger the larger it is.
  Matrix<R> inverse() const;

 private:
  struct Factors;
  std::unique_ptr<Factors> factors_;
};

/// What was solved: matrix x solution = right. The condition is that of the matrix's singular values.
SolvedSystem describe(std::string name, const Matrix<double>& matrix, int rank, const Matrix<double>& right,
                      const Matrix<double>& solution);

}  // namespace cageproof::solved
