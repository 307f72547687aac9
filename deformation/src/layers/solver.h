// SPDX-License-Identifier: MIT
// Systems that are solved for one right side, and said to have been.
#pragma once

#include "cageproof/deformation/deformer.h"

#include <string>

namespace cageproof::deformation {

/// The solution of least residual and least norm of matrix x solution = right (core's LeastSquares).
/// \param solved takes what there is to say of it
template <Scalar R>
Matrix<R> least_squares(const Matrix<R>& matrix, const Matrix<R>& right, std::string name,
                        std::vector<SolvedSystem>& solved) {
  const LeastSquares<R> factors(matrix);
  Matrix<R> solution = factors.solve(right);
  solved.push_back(describe<R>(std::move(name), matrix, factors.rank(), right, solution));
  return solution;
}

}  // namespace cageproof::deformation
