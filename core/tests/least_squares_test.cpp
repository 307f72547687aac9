// SPDX-License-Identifier: MIT
// Least squares: against normal equations in 100 digits, in any unit, and what is said of ranks and conditions.
#include "cageproof/core/numbers/least_squares.h"

#include "cageproof/core/input_error.h"

#include <Eigen/LU>
#include <gtest/gtest.h>

#include <cmath>

namespace cageproof {
namespace {

// Six equations for three unknowns, and two right sides.
Matrix<double> equations() {
  Matrix<double> m(6, 3);
  m << 1, 2, -1, 0.5, -3, 2, 2, 0, 1, -1, 1, 4, 0.25, 0.75, 1, 3, -2, 0;
  return m;
}
Matrix<double> sides() {
  Matrix<double> b(6, 2);
  b << 1, 0, 2, -1, 0, 3, -2, 0.5, 1, 1, 4, -3;
  return b;
}

Matrix<double> by_normal_equations(const Matrix<double>& matrix, const Matrix<double>& right) {
  const Matrix<Mp100> m = matrix.cast<Mp100>(), b = right.cast<Mp100>();
  const Matrix<Mp100> solved = Matrix<Mp100>(m.transpose() * m).fullPivLu().solve(Matrix<Mp100>(m.transpose() * b));
  return solved.cast<double>();
}

TEST(least_squares, are_those_of_the_normal_equations) {
  const LeastSquares<double> factors(equations());
  EXPECT_EQ(factors.rank(), 3);
  EXPECT_LT((factors.solve(sides()) - by_normal_equations(equations(), sides())).norm(), 1e-14);
  EXPECT_LT((factors.inverse() * sides() - factors.solve(sides())).norm(), 1e-14);
}

// Squares of these leave the range of double.
TEST(least_squares, do_not_depend_on_units) {
  const Matrix<double> truth = LeastSquares<double>(equations()).solve(sides());
  for (const int of_matrix : {-800, -300, 300, 800})
    for (const int of_right : {-100, 0, 100}) {
      const double a = std::ldexp(1, of_matrix), b = std::ldexp(1, of_right);
      const LeastSquares<double> factors(equations() * a);
      EXPECT_EQ(factors.rank(), 3) << of_matrix;
      EXPECT_EQ(Matrix<double>(factors.solve(sides() * b) * (a / b)), truth) << of_matrix << ' ' << of_right;
      const SolvedSystem said = describe<double>("scaled", equations() * a, 3, sides() * b, factors.solve(sides() * b));
      const SolvedSystem plain = describe<double>("plain", equations(), 3, sides(), truth);
      EXPECT_NEAR(said.condition / plain.condition, 1, 1e-12);
      EXPECT_NEAR(said.residual / plain.residual, 1, 1e-12);
    }
}

TEST(least_squares, take_the_least_solution_of_what_is_deficient) {
  Matrix<double> twice(6, 4);
  twice << equations(), equations().col(0);
  const LeastSquares<double> factors(twice);
  EXPECT_EQ(factors.rank(), 3);
  // Both copies of a column take half.
  const Matrix<double> found = factors.solve(sides()), single = LeastSquares<double>(equations()).solve(sides());
  EXPECT_LT((found.row(0) - single.row(0) / 2).norm(), 1e-14);
  EXPECT_LT((found.row(3) - single.row(0) / 2).norm(), 1e-14);
  EXPECT_TRUE(describe<double>("twice", twice, factors.rank(), sides(), found).is_singular());
  const LeastSquares<double> nothing(Matrix<double>::Zero(3, 2));
  EXPECT_EQ(nothing.rank(), 0);
  EXPECT_EQ(nothing.solve(Matrix<double>::Ones(3, 1)).norm(), 0);
}

TEST(least_squares, refuse_what_is_not_finite) {
  for (const double bad : {static_cast<double>(NAN), static_cast<double>(INFINITY)}) {
    Matrix<double> matrix = equations();
    matrix(4, 1) = bad;
    EXPECT_THROW(LeastSquares<double>{matrix}, InputError);
  }
}

}  // namespace
}  // namespace cageproof
