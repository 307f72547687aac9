// SPDX-License-Identifier: MIT
// Square systems of boundary equations in space, which have thousands of unknowns.
#pragma once

#include "cageproof/core/numbers/least_squares.h"

namespace cageproof::solved {

/// A solution, and in double what is said of the system.
template <Scalar R>
struct SquareSolution {
  Matrix<R> found;
  std::vector<SolvedSystem> described;
};

/// Solves matrix x found = right: in double by elimination with row pivots, block by block, which takes 2/3 n^3
/// operations; in multiprecision as LeastSquares. The condition that is described is the largest singular value over
/// the least, by at most 40 steps of iteration each, to some percent.
/// \throws InputError for a matrix that is not finite, or singular in double
template <Scalar R>
SquareSolution<R> solve_square(const std::string& name, const Matrix<R>& matrix, const Matrix<R>& right);

}  // namespace cageproof::solved
