// SPDX-License-Identifier: MIT
#include "solver.h"

#include <Eigen/QR>
#include <Eigen/SVD>

#include <algorithm>
#include <limits>

namespace cageproof::deformation {
namespace {

double condition_of(const Matrix<double>& matrix) {
  // The triangle of a QR factorisation has the matrix's singular values, and is as small as they are many.
  const Matrix<double> triangle =
      Eigen::HouseholderQR<Matrix<double>>(matrix).matrixQR().topRows(std::min(matrix.rows(), matrix.cols()));
  const Matrix<double> upper = triangle.triangularView<Eigen::Upper>();
  const Eigen::VectorXd values = Eigen::BDCSVD<Matrix<double>>(upper).singularValues();
  const double least = values[values.size() - 1];
  return least > 0 ? values[0] / least : std::numeric_limits<double>::infinity();
}

SolvedSystem description_of(std::string name, const Matrix<double>& matrix, Eigen::Index rank,
                            const Matrix<double>& right, const Matrix<double>& solution) {
  const Eigen::VectorXd sizes = right.colwise().norm(), left = (matrix * solution - right).colwise().norm();
  double residual = 0;
  for (Eigen::Index k = 0; k < sizes.size(); ++k)
    if (sizes[k] > 0) residual = std::max(residual, left[k] / sizes[k]);
  return {.name = std::move(name),
          .rows = static_cast<int>(matrix.rows()),
          .columns = static_cast<int>(matrix.cols()),
          .rank = static_cast<int>(rank),
          .condition = condition_of(matrix),
          .residual = residual};
}

}  // namespace

template <Scalar R>
Factored<R>::Factored(Matrix<R> matrix) : matrix_(std::move(matrix)) {
  factors_.setThreshold(R(1e-13));
  factors_.compute(matrix_);
}

template <Scalar R>
SolvedSystem Factored<R>::described(std::string name, const Matrix<R>& right, const Matrix<R>& solution) const {
  if constexpr (std::same_as<R, double>) return description_of(std::move(name), matrix_, rank(), right, solution);
  else
    return description_of(std::move(name), matrix_.template cast<double>(), rank(), right.template cast<double>(),
                          solution.template cast<double>());
}

template <Scalar R>
Matrix<R> least_squares(const Matrix<R>& matrix, const Matrix<R>& right, std::string name,
                        std::vector<SolvedSystem>* solved) {
  const Factored<R> factored(matrix);
  Matrix<R> solution = factored.solve(right);
  if (solved) solved->push_back(factored.described(std::move(name), right, solution));
  return solution;
}

template class Factored<double>;
template class Factored<Mp50>;
template Matrix<double> least_squares<double>(const Matrix<double>&, const Matrix<double>&, std::string,
                                              std::vector<SolvedSystem>*);
template Matrix<Mp50> least_squares<Mp50>(const Matrix<Mp50>&, const Matrix<Mp50>&, std::string,
                                          std::vector<SolvedSystem>*);

}  // namespace cageproof::deformation
