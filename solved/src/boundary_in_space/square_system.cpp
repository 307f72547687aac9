// SPDX-License-Identifier: MIT
#include "square_system.h"

#include "cageproof/core/input_error.h"

#include <Eigen/LU>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace cageproof::solved {
namespace {

using Doubles = Eigen::VectorXd;
using Elimination = Eigen::PartialPivLU<Matrix<double>>;

// The root of the largest eigenvalue of a symmetric map, by iteration from a vector that no symmetry of a cage keeps.
template <class Map>
double largest_root(Eigen::Index size, const Map& map) {
  constexpr int most_steps = 40;
  constexpr double enough = 1e-3;
  Doubles v(size);
  for (Eigen::Index k = 0; k < size; ++k) v[k] = 1 + std::sin(1.7 * static_cast<double>(k));
  v.normalize();
  double root = 0;
  for (int step = 0; step < most_steps; ++step) {
    v = map(v);
    const double norm = v.norm(), next = std::sqrt(norm);
    if (!std::isfinite(norm) || norm == 0) return next;
    v /= norm;
    if (std::abs(next - root) <= enough * next) return next;
    root = next;
  }
  return root;
}

double condition_of(const Matrix<double>& matrix, const Elimination& factors) {
  const double largest =
      largest_root(matrix.rows(), [&](const Doubles& v) { return Doubles(matrix.transpose() * Doubles(matrix * v)); });
  const double of_inverse = largest_root(
      matrix.rows(), [&](const Doubles& v) { return Doubles(factors.transpose().solve(Doubles(factors.solve(v)))); });
  // The inverse's map is applied the other way round, which has the same singular values.
  return largest * of_inverse;
}

double residual_of(const Matrix<double>& matrix, const Matrix<double>& found, const Matrix<double>& right) {
  const Doubles left = (matrix * found - right).colwise().norm(), sizes = right.colwise().norm();
  double worst = 0;
  for (Eigen::Index k = 0; k < sizes.size(); ++k)
    if (sizes[k] > 0) worst = std::max(worst, left[k] / sizes[k]);
  return worst;
}

}  // namespace

template <Scalar R>
SquareSolution<R> solve_square(const std::string& name, const Matrix<R>& matrix, const Matrix<R>& right) {
  if constexpr (!std::same_as<R, double>) {
    return {LeastSquares<R>(matrix).solve(right), {}};
  } else {
    if (!matrix.allFinite() || !right.allFinite())
      throw InputError(name + ": layers are not finite on the cage: lengths leave the range, or a face has no area");
    const Elimination factors(matrix);
    SquareSolution<double> solution{factors.solve(right), {}};
    if (!solution.found.allFinite())
      throw InputError(name + ": the system is singular in double: faces of the cage lie on each other, or nearly so");
    const int rows = static_cast<int>(matrix.rows());
    solution.described = {{.name = name,
                           .rows = rows,
                           .columns = rows,
                           .rank = rows,
                           .condition = condition_of(matrix, factors),
                           .residual = residual_of(matrix, solution.found, right)}};
    return solution;
  }
}

template SquareSolution<double> solve_square<double>(const std::string&, const Matrix<double>&, const Matrix<double>&);
template SquareSolution<Mp50> solve_square<Mp50>(const std::string&, const Matrix<Mp50>&, const Matrix<Mp50>&);
template SquareSolution<Mp100> solve_square<Mp100>(const std::string&, const Matrix<Mp100>&, const Matrix<Mp100>&);

}  // namespace cageproof::solved
