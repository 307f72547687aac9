// SPDX-License-Identifier: MIT
// Least squares whose solution may not be negative.
#pragma once

#include "cageproof/deformation/deformer.h"

#include <vector>

namespace cageproof::deformation {

/// The minimum of |A s - b| subject to s >= 0, and how well it satisfies the conditions of Karush, Kuhn and Tucker.
template <Scalar R>
struct NonNegativeSolution {
  Matrix<R> values;  ///< one column; zeros are exactly that
  int zeros;
  /// Of A. Where it is less than A's columns, other solutions leave as little, and this is one of them.
  int rank;
  /// The largest violation: a negative number of the solution over its largest, or a gradient by which a zero should
  /// grow, over the norms of its column and of b.
  double violation;
  bool is_optimal;  ///< whether the violation is no more than rounding
};

/// The columns that are not zero are found as those of a quadratic program in double (NLopt's SLSQP); on them the
/// solution is that of least norm of core's LeastSquares in R, and they are exchanged until the conditions hold.
/// R: double, Mp50
/// \param right one column \throws InputError for numbers that are not finite
template <Scalar R>
NonNegativeSolution<R> nonnegative_least_squares(const Matrix<R>& matrix, const Matrix<R>& right);

}  // namespace cageproof::deformation
