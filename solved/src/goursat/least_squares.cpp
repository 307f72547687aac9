// SPDX-License-Identifier: MIT
#include "least_squares.h"

#include <Eigen/QR>

namespace cageproof::solved::goursat {
namespace {

// Largest over smallest singular value of a triangle, by power iterations on both ends: a lower bound, that is close.
double condition_of(const Eigen::MatrixXd& triangle) {
  constexpr int steps = 20;
  const auto upper = triangle.triangularView<Eigen::Upper>();
  Eigen::VectorXd x = Eigen::VectorXd::Constant(triangle.cols(), 1), y = x;
  double largest = 0, inverse = 0;
  for (int i = 0; i < steps; ++i) {
    x = (upper * x.normalized()).eval();
    largest = x.norm();
    x = (upper.adjoint() * x).eval();
    y = upper.adjoint().solve(y.normalized());
    inverse = y.norm();
    y = upper.solve(y);
  }
  return largest * inverse;
}

}  // namespace

LeastSquares solve_least_squares(Eigen::MatrixXd& a, const Eigen::MatrixXd& b, double threshold) {
  const Eigen::Index n = a.cols();
  Eigen::VectorXd unit = a.colwise().norm().transpose();
  for (double& length : unit) length = length > 0 ? 1 / length : 1;
  a *= unit.asDiagonal();
  const Eigen::HouseholderQR<Eigen::Ref<Eigen::MatrixXd>> by_blocks(a);
  Eigen::MatrixXd turned = b;
  turned.applyOnTheLeft(by_blocks.householderQ().adjoint());
  const Eigen::MatrixXd triangle = by_blocks.matrixQR().topRows(n).triangularView<Eigen::Upper>();
  Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> revealing;
  revealing.setThreshold(threshold);
  revealing.compute(triangle);
  LeastSquares found;
  found.solution = revealing.solve(turned.topRows(n));
  // The residual in the triangle's rows, from columns beyond the rank, and outside of all columns.
  const Eigen::MatrixXd left = triangle * found.solution - turned.topRows(n);
  found.residual = 0;
  for (Eigen::Index j = 0; j < b.cols(); ++j) {
    const double whole = b.col(j).norm();
    const double rest = std::hypot(left.col(j).norm(), turned.col(j).tail(a.rows() - n).norm());
    if (whole > 0) found.residual = std::max(found.residual, rest / whole);
  }
  found.solution = unit.asDiagonal() * found.solution;
  found.rank = static_cast<int>(revealing.rank());
  found.condition = condition_of(revealing.matrixT().topLeftCorner(found.rank, found.rank));
  return found;
}

}  // namespace cageproof::solved::goursat
