// SPDX-License-Identifier: MIT
#include "rounding_terms.h"

namespace cageproof::deformation {

Matrix<double> rounding_terms(const Matrix<double>& matrix, const Matrix<double>& right,
                              const Matrix<double>& solution) {
  // The pseudo-inverse of the triangle of a QR factorisation has rows of the same lengths, and is small.
  const Eigen::VectorXd rows = LeastSquares<double>(qr_factors(matrix).triangle).inverse().rowwise().norm();
  const Eigen::RowVectorXd columns = matrix.colwise().norm();
  const Eigen::RowVectorXd roundings = right.colwise().norm() + columns * solution.cwiseAbs();
  return rows * roundings;
}

}  // namespace cageproof::deformation
