// SPDX-License-Identifier: MIT
// Least squares with nearly dependent columns.
#pragma once

#include <Eigen/Core>

namespace cageproof::solved::goursat {

struct LeastSquares {
  Eigen::MatrixXd solution;
  int rank;
  double condition;  ///< largest over smallest singular value of what is kept; a lower bound, within some per cent
  double residual;   ///< the largest of the right sides' columns, relative, in Euclidean norms
};

/// The least solution, columns scaled to unit length, of the problem without what lies below `threshold` of the largest
/// pivot: a QR factorisation by blocks, then a complete orthogonal one of its triangle, which reveals the rank.
/// \param a overwritten \pre at least as many rows as columns
LeastSquares solve_least_squares(Eigen::MatrixXd& a, const Eigen::MatrixXd& b, double threshold);

}  // namespace cageproof::solved::goursat
