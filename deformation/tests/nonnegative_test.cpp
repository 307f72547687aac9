// SPDX-License-Identifier: MIT
// Least squares without negative numbers, against all sets of columns that may be zero, and its use for aligned
// normals.
#include "../src/nonnegative.h"
#include "support.h"

#include "cageproof/core/input_error.h"
#include "cageproof/core/numbers/random_stream.h"

#include <gtest/gtest.h>

#include <Eigen/QR>

#include <map>

namespace cageproof::deformation::test::nonnegative_test {
namespace {

Matrix<double> random_matrix(std::string_view name, std::uint64_t index, Eigen::Index rows, Eigen::Index columns) {
  RandomStream random(1, name, index);
  Matrix<double> found(rows, columns);
  for (double& x : found.reshaped()) x = random.uniform(-1, 1);
  return found;
}

// The least residual over all sets of columns: that of the solution is among them.
double least_residual(const Matrix<double>& matrix, const Matrix<double>& right) {
  const auto n = static_cast<unsigned>(matrix.cols());
  double least = right.norm();
  for (unsigned set = 1; set < 1U << n; ++set) {
    std::vector<int> columns;
    for (unsigned k = 0; k < n; ++k)
      if ((set >> k & 1U) != 0) columns.push_back(static_cast<int>(k));
    const Matrix<double> part = matrix(Eigen::all, columns);
    const Matrix<double> solution = part.colPivHouseholderQr().solve(right);
    if (solution.minCoeff() >= 0) least = std::min(least, (part * solution - right).norm());
  }
  return least;
}

template <Scalar R>
void expect_conditions(const Matrix<R>& matrix, const Matrix<R>& right, const Matrix<R>& s, double rounding) {
  const Matrix<R> gradient = matrix.transpose() * (matrix * s - right);
  for (Eigen::Index k = 0; k < s.rows(); ++k) {
    const double bound = rounding * static_cast<double>(R(matrix.col(k).norm() * right.norm()));
    EXPECT_GE(s(k, 0), 0);
    EXPECT_GE(static_cast<double>(gradient(k, 0)), -bound) << k;
    if (s(k, 0) > 0) {
      EXPECT_LE(static_cast<double>(gradient(k, 0)), bound) << k;
    }
  }
}

TEST(nonnegative, is_the_best_of_all_sets_of_columns) {
  std::map<int, int> zeros;
  for (std::uint64_t i = 0; i < 60; ++i) {
    const Eigen::Index n = 1 + static_cast<Eigen::Index>(i % 9);
    Matrix<double> matrix = random_matrix("nonnegative/matrix", i, n + 2, n);
    // Columns of sizes that are far apart.
    for (Eigen::Index k = 0; k < n; ++k) matrix.col(k) *= std::pow(10., static_cast<double>(k % 5) - 2);
    const Matrix<double> right = random_matrix("nonnegative/right", i, n + 2, 1);
    const auto found = nonnegative_least_squares<double>(matrix, right);
    EXPECT_TRUE(found.is_optimal) << i;
    EXPECT_EQ(found.rank, n);
    EXPECT_NEAR((matrix * found.values - right).norm(), least_residual(matrix, right), 1e-14) << i;
    expect_conditions<double>(matrix, right, found.values, 1e-13);
    EXPECT_EQ(found.zeros, (found.values.array() == 0).count());
    ++zeros[found.zeros];
  }
  EXPECT_GE(zeros.size(), 5U);
}

TEST(nonnegative, meets_the_conditions_of_ill_conditioned_systems_in_both_scalars) {
  for (std::uint64_t i = 0; i < 6; ++i) {
    Matrix<double> matrix = random_matrix("nonnegative/large", i, 120, 40);
    // Columns that are nearly those before them: a condition of 1e5.
    for (Eigen::Index k = 1; k < 40; k += 2) matrix.col(k) = matrix.col(k - 1) + 1e-5 * matrix.col(k);
    const Matrix<double> right = random_matrix("nonnegative/data", i, 120, 1);
    const auto found = nonnegative_least_squares<double>(matrix, right);
    EXPECT_TRUE(found.is_optimal) << found.violation;
    expect_conditions<double>(matrix, right, found.values, 1e-12);
    const Matrix<Mp50> wide = matrix.cast<Mp50>(), data = right.cast<Mp50>();
    const auto exact = nonnegative_least_squares<Mp50>(wide, data);
    EXPECT_TRUE(exact.is_optimal) << exact.violation;
    expect_conditions<Mp50>(wide, data, exact.values, 1e-45);
    EXPECT_EQ(found.zeros, exact.zeros);
    EXPECT_LT((found.values - exact.values.cast<double>()).norm(), 1e-9 * found.values.norm());
  }
}

TEST(nonnegative, takes_what_is_zero_or_dependent) {
  Matrix<double> matrix = random_matrix("nonnegative/dependent", 0, 8, 5);
  const Matrix<double> right = random_matrix("nonnegative/dependent right", 0, 8, 1);
  const auto none = nonnegative_least_squares<double>(matrix, Matrix<double>::Zero(8, 1));
  EXPECT_EQ(none.zeros, 5);
  EXPECT_TRUE(none.is_optimal);
  matrix.col(3) = 2 * matrix.col(1);
  matrix.col(4).setZero();
  const auto found = nonnegative_least_squares<double>(matrix, right);
  EXPECT_EQ(found.rank, 3);
  EXPECT_TRUE(found.is_optimal) << found.violation;
  EXPECT_NEAR((matrix * found.values - right).norm(), least_residual(matrix.leftCols(3), right), 1e-14);
  expect_conditions<double>(matrix, right, found.values, 1e-13);
  matrix(2, 2) = NAN;
  EXPECT_THROW(nonnegative_least_squares<double>(matrix, right), InputError);
}

constexpr double kHard = 0, kNonNegative = 3;

TEST(nonnegative, alignment_is_hard_alignment_where_that_has_no_negative_stretch) {
  const Case c = cube();
  for (const char* method : {"aaap", "tp"}) {
    const auto hard = deformed(*prepared(c.cage, method, {1, 1, kHard, 1, 1}), c.posed, c.points),
               other = deformed(*prepared(c.cage, method, {1, 1, kNonNegative, 1, 1}), c.posed, c.points);
    for (std::size_t i = 0; i < hard.tensors[0].size(); ++i)
      EXPECT_NEAR(hard.tensors[0][i], other.tensors[0][i], 1e-12) << method;
  }
}

// Hard alignment has stretches of -25 to 28 there.
TEST(nonnegative, alignment_keeps_the_stretches_of_ahap_from_being_negative) {
  const Case c = cube();
  const auto report = [&](double alignment) {
    return prepared(c.cage, "ahap", {1, 1, alignment, 1, 1})->pose({c.posed, {}})->report();
  };
  const DeformationReport hard = report(kHard), found = report(kNonNegative);
  EXPECT_NEAR(figure(hard, "least sigma"), -25.20055, 1e-5);
  EXPECT_EQ(figure(found, "least sigma"), 0);
  EXPECT_GT(figure(found, "zero sigma"), 0);
  EXPECT_TRUE(found.warnings.empty());
  EXPECT_GT(figure(found, "energy a sample"), figure(hard, "energy a sample"));
  EXPECT_LT(figure(found, "energy a sample"), figure(found, "energy a sample, unit normals"));
}

TEST(nonnegative, refuses_what_is_not_finite) {
  const Matrix<double> matrix = Matrix<double>::Identity(3, 2);
  Matrix<double> right = Matrix<double>::Ones(3, 1);
  for (const double bad : {static_cast<double>(NAN), static_cast<double>(INFINITY)}) {
    right(1, 0) = bad;
    EXPECT_THROW(nonnegative_least_squares<double>(matrix, right), InputError) << bad;
  }
}

}  // namespace
}  // namespace cageproof::deformation::test::nonnegative_test
