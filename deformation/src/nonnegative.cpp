// SPDX-License-Identifier: MIT
#include "nonnegative.h"

#include "cageproof/core/input_error.h"

#include "cageproof/core/numbers/scalar.h"

#ifndef CAGEPROOF_NO_NLOPT
#include <nlopt.h>
#endif

#include <algorithm>
#include <memory>

namespace cageproof::deformation {
namespace {

using ColumnSet = std::vector<bool>;

// The columns with this value, as indices for Eigen.
std::vector<Eigen::Index> members(const ColumnSet& set, bool value) {
  std::vector<Eigen::Index> found;
  found.reserve(set.size());
  for (std::size_t k = 0; k < set.size(); ++k)
    if (set[k] == value) found.push_back(static_cast<Eigen::Index>(k));
  return found;
}

#ifdef CAGEPROOF_NO_NLOPT

// Where the exchanges start: with none.
ColumnSet program_columns(const Matrix<double>& matrix, const Matrix<double>& /*right*/, bool /*deficient*/) {
  return ColumnSet(static_cast<std::size_t>(matrix.cols()), false);
}

#else

// Least |y - target|^2 / 2 subject to rows y >= 0.
struct QuadraticProgram {
  Eigen::VectorXd target;
  Eigen::MatrixXd rows;

  static double value(unsigned n, const double* y, double* gradient, void* data) {
    const Eigen::VectorXd from = Eigen::Map<const Eigen::VectorXd>(y, n) - of(data).target;
    if (gradient != nullptr) Eigen::Map<Eigen::VectorXd>(gradient, n) = from;
    return from.squaredNorm() / 2;
  }

  // NLopt keeps these at most zero.
  static void negatives(unsigned m, double* result, unsigned n, const double* y, double* gradient, void* data) {
    using Rows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
    Eigen::Map<Eigen::VectorXd>(result, m) = -of(data).rows * Eigen::Map<const Eigen::VectorXd>(y, n);
    if (gradient != nullptr) Eigen::Map<Rows>(gradient, m, n) = -of(data).rows;
  }

 private:
  static const QuadraticProgram& of(void* data) { return *static_cast<const QuadraticProgram*>(data); }
};

// With A = Q T, T triangular, y = T s and c = Q^T b, |A s - b|^2 is |y - c|^2 and a constant. The Hessian is the
// identity, with which SLSQP starts, so its first subproblem is the whole problem. Below a
// deficient matrix stands a small multiple of the identity, because T has no inverse otherwise. Rows of T^-1 are scaled
// to norm one, which changes no sign.
ColumnSet program_columns(const Matrix<double>& matrix, const Matrix<double>& right, bool deficient) {
  const Eigen::Index n = matrix.cols(), rows = matrix.rows();
  Eigen::MatrixXd held = Eigen::MatrixXd::Zero(rows + n, n);
  held.topRows(rows) = matrix;
  if (deficient) held.bottomRows(n).diagonal().setConstant(1e-6);
  Matrix<double> data = Matrix<double>::Zero(rows + n, 1);
  data.topRows(rows) = right;
  const QrFactors factors = qr_factors(held, data);
  const Matrix<double>& triangle = factors.triangle;
  const double size = std::max(right.norm(), std::numeric_limits<double>::min());
  QuadraticProgram program{factors.turned.col(0).head(n) / size,
                           triangle.triangularView<Eigen::Upper>().solve(Eigen::MatrixXd::Identity(n, n))};
  program.rows.rowwise().normalize();
  const auto count = static_cast<unsigned>(n);
  const std::unique_ptr<nlopt_opt_s, void (*)(nlopt_opt)> solver(nlopt_create(NLOPT_LD_SLSQP, count), nlopt_destroy);
  nlopt_set_min_objective(solver.get(), QuadraticProgram::value, &program);
  // Rounding takes zeros to either side, and NLopt gives none but points that it takes for feasible.
  const std::vector<double> tolerances(count, 1e-10);
  nlopt_add_inequality_mconstraint(solver.get(), count, QuadraticProgram::negatives, &program, tolerances.data());
  nlopt_set_ftol_rel(solver.get(), 1e-15);
  nlopt_set_maxeval(solver.get(), 20);
  std::vector<double> y(count, 0.0);
  double least = 0;
  // Whether it succeeds is for the conditions to say.
  nlopt_optimize(solver.get(), y.data(), &least);
  const Eigen::VectorXd distances = program.rows * Eigen::Map<const Eigen::VectorXd>(y.data(), n);
  ColumnSet positive(count, false);
  for (Eigen::Index k = 0; k < n; ++k) positive[k] = distances[k] > 1e-9;
  return positive;
}

#endif

template <Scalar R>
struct Attempt {
  Matrix<R> values;
  std::vector<std::size_t> misplaced;
  double violation = 0;
};

// The solution on a set of columns, whose norms are one, and which columns are on the wrong side.
template <Scalar R>
Attempt<R> attempt(const Matrix<R>& matrix, const Matrix<R>& right, const ColumnSet& positive, double tolerance) {
  Attempt<R> found{Matrix<R>::Zero(matrix.cols(), 1), {}};
  const auto columns = members(positive, true);
  if (!columns.empty()) {
    const Matrix<R> on_columns = LeastSquares<R>(matrix(Eigen::all, columns)).solve(right);
    for (std::size_t k = 0; k < columns.size(); ++k)
      found.values(columns[k], 0) = on_columns(static_cast<Eigen::Index>(k), 0);
  }
  const Matrix<R> growth = matrix.transpose() * (right - matrix * found.values);
  const R largest = found.values.cwiseAbs().maxCoeff(), size = right.norm();
  for (Eigen::Index k = 0; k < matrix.cols(); ++k) {
    const R amount = positive[k] ? R(-found.values(k, 0)) : growth(k, 0), whole = positive[k] ? largest : size;
    if (!(amount > 0)) continue;
    const auto violation = static_cast<double>(R(amount / whole));
    // A number that is negative at all is none of the solution's.
    if (positive[k] || violation > tolerance) found.misplaced.push_back(static_cast<std::size_t>(k));
    found.violation = std::max(found.violation, violation);
  }
  return found;
}

// All misplaced columns change sides as long as they become fewer; then only the last one does, which ends if columns
// are independent (Murty 1974).
template <Scalar R>
Attempt<R> exchanged(const Matrix<R>& matrix, const Matrix<R>& right, ColumnSet& positive) {
  const double tolerance =
      64 * static_cast<double>(std::max(matrix.rows(), matrix.cols())) * static_cast<double>(unit_roundoff<R>());
  Attempt<R> found = attempt(matrix, right, positive, tolerance);
  std::size_t fewest = positive.size() + 1;
  for (int left = 20 + 3 * static_cast<int>(matrix.cols()); left > 0 && !found.misplaced.empty(); --left) {
    const bool together = found.misplaced.size() < fewest;
    if (!together) found.misplaced.erase(found.misplaced.begin(), found.misplaced.end() - 1);
    else fewest = found.misplaced.size();
    for (const std::size_t k : found.misplaced) positive[k] = !positive[k];
    found = attempt(matrix, right, positive, tolerance);
  }
  return found;
}

}  // namespace

template <Scalar R>
NonNegativeSolution<R> nonnegative_least_squares(const Matrix<R>& matrix, const Matrix<R>& right) {
  for (const R& x : right.reshaped())
    if (!(x - x == 0))
      throw InputError("the conditions that determine the stretches are not finite: the pose is too large");
  Matrix<R> norms = matrix.colwise().norm();
  for (R& norm : norms.reshaped())
    if (norm == 0) norm = R(1);
  const Matrix<R> scaled = matrix * norms.reshaped().cwiseInverse().asDiagonal();
  const int rank = LeastSquares<R>(scaled).rank();
  const bool deficient = rank < scaled.cols();
  ColumnSet positive;
  if constexpr (std::same_as<R, double>) {
    positive = program_columns(scaled, right, deficient);
  } else {
    // Exchanges take a system each, which double solves sooner.
    const Matrix<double> rounded = scaled.template cast<double>(), data = right.template cast<double>();
    positive = program_columns(rounded, data, deficient);
    exchanged<double>(rounded, data, positive);
  }
  const Attempt<R> found = exchanged<R>(scaled, right, positive);
  NonNegativeSolution<R> solution{Matrix<R>::Zero(matrix.cols(), 1), 0, rank, found.violation, found.misplaced.empty()};
  for (Eigen::Index k = 0; k < matrix.cols(); ++k) {
    if (found.values(k, 0) > 0) solution.values(k, 0) = found.values(k, 0) / norms(0, k);
    else ++solution.zeros;
  }
  return solution;
}

template NonNegativeSolution<double> nonnegative_least_squares<double>(const Matrix<double>&, const Matrix<double>&);
template NonNegativeSolution<Mp50> nonnegative_least_squares<Mp50>(const Matrix<Mp50>&, const Matrix<Mp50>&);

}  // namespace cageproof::deformation
