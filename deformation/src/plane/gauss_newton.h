// SPDX-License-Identifier: MIT
// Steps of Gauss and Newton with constraints.
#pragma once

#include "cageproof/core/numbers/least_squares.h"

namespace cageproof::deformation {

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
  GaussNewtonStep<R> found{LeastSquares<R>(k).solve(Matrix<R>(-c)), R(0), R(0), free, k.cols() - free};
  const Matrix<R> gradient = 2 * j.transpose() * g;
  if (free > 0) {
    const Matrix<R> reduced = j * along;
    found.step += along * LeastSquares<R>(reduced).solve(Matrix<R>(-(g + j * found.step)));
    found.projected_gradient = Matrix<R>(along.transpose() * gradient).cwiseAbs().maxCoeff();
  }
  const Matrix<R> force = 2 * j.transpose() * (g + j * found.step);
  found.multiplier = LeastSquares<R>(Matrix<R>(k.transpose())).solve(force).norm();
  return found;
}

}  // namespace cageproof::deformation
