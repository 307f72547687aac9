// SPDX-License-Identifier: MIT
// Steps of Gauss and Newton with constraints.
#pragma once

#include "cageproof/core/numbers/least_squares.h"

#include <Eigen/QR>

#include <utility>

namespace cageproof::deformation {

/// The solution of least residual and least norm, and the rank. Second derivatives at an edge are as large as it is
/// short, squared, and say little of other edges. In 50 digits columns count as dependent only where others give them
/// to 1e-33, and not, as in LeastSquares, where double would count them so.
template <Scalar R>
std::pair<Matrix<R>, Eigen::Index> least_squares(const Matrix<R>& matrix, const Matrix<R>& right) {
  if constexpr (std::same_as<R, double>) {
    const LeastSquares<R> factors(matrix);
    return {factors.solve(right), factors.rank()};
  } else {
    Eigen::CompleteOrthogonalDecomposition<Matrix<R>> factors;
    factors.setThreshold(R(1e-33));
    factors.compute(matrix);
    return {factors.solve(right), factors.rank()};
  }
}

/// A step, and what there is to say of where it begins.
template <Scalar R>
struct GaussNewtonStep {
  Matrix<R> step;
  R multiplier;             ///< the norm of the constraints' multipliers: what the merit's weight must exceed
  R projected_gradient;     ///< of E along the constraints, its largest number
  Eigen::Index free, rank;  ///< of the unknowns, and of the constraints
};

/// Where the constraints c + K d = 0 are met, |g + J d|^2 is least on the null space of K.
template <Scalar R>
GaussNewtonStep<R> gauss_newton(const Matrix<R>& g, const Matrix<R>& j, const Matrix<R>& c, const Matrix<R>& k) {
  const Matrix<R> along = null_space<R>(k);
  const Eigen::Index free = along.cols();
  GaussNewtonStep<R> found{least_squares<R>(k, -c).first, R(0), R(0), free, k.cols() - free};
  const Matrix<R> gradient = 2 * j.transpose() * g;
  if (free > 0) {
    const Matrix<R> reduced = j * along;
    found.step += along * least_squares<R>(reduced, -(g + j * found.step)).first;
    found.projected_gradient = Matrix<R>(along.transpose() * gradient).cwiseAbs().maxCoeff();
  }
  const Matrix<R> force = 2 * j.transpose() * (g + j * found.step);
  found.multiplier = least_squares<R>(k.transpose(), force).first.norm();
  return found;
}

}  // namespace cageproof::deformation
