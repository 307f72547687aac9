// SPDX-License-Identifier: MIT
#include "least_squares.h"

#include <Eigen/QR>

namespace cageproof::solved {

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
  // What the kept rank leaves of the triangle's rows, and what lies in no column at all.
  const Eigen::MatrixXd left = triangle * found.solution - turned.topRows(n);
  found.residual = 0;
  for (Eigen::Index j = 0; j < b.cols(); ++j) {
    const double whole = b.col(j).norm();
    const double rest = std::hypot(left.col(j).norm(), turned.col(j).tail(a.rows() - n).norm());
    if (whole > 0) found.residual = std::max(found.residual, rest / whole);
  }
  found.solution = unit.asDiagonal() * found.solution;
  found.rank = static_cast<int>(revealing.rank());
  const auto pivots = revealing.matrixQTZ().diagonal().cwiseAbs();
  found.condition = found.rank > 0 ? pivots[0] / pivots[found.rank - 1] : 0;
  return found;
}

}  // namespace cageproof::solved
