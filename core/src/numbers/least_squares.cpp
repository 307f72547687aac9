// SPDX-License-Identifier: MIT
#include "cageproof/core/numbers/least_squares.h"

#include "cageproof/core/input_error.h"

#include <Eigen/QR>
#include <Eigen/SVD>

#include <algorithm>
#include <cmath>
#include <limits>

namespace cageproof {

template <Scalar R>
struct LeastSquares<R>::Factors {
  Eigen::CompleteOrthogonalDecomposition<Matrix<R>> of_matrix;  ///< divided by unit
  R unit;
};

namespace {

// The power of two next to a matrix's largest number; one for zero. Squares of numbers over it stay in range, and
// dividing by it rounds nothing.
template <Scalar R>
R unit_of(const Matrix<R>& matrix) {
  const auto largest = matrix.size() > 0 ? static_cast<double>(R(matrix.cwiseAbs().maxCoeff())) : 0.0;
  return largest > 0 && std::isfinite(largest) ? R(std::exp2(std::clamp(std::ilogb(largest), -1000, 1000))) : R(1);
}

}  // namespace

template <Scalar R>
LeastSquares<R>::LeastSquares(const Matrix<R>& matrix) {
  for (const R& x : matrix.reshaped())
    if (!(x - x == 0))
      throw InputError(
          "layers are not finite on the cage: the evaluation has no limits there, or lengths leave the range");
  auto factors = std::make_unique<Factors>();
  // The threshold lies between systems that are singular up to rounding (conditions of 1e15 and more) and others.
  factors->of_matrix.setThreshold(R(1e-13));
  factors->unit = unit_of(matrix);
  factors->of_matrix.compute(Matrix<R>(matrix / factors->unit));
  factors_ = std::move(factors);
}

template <Scalar R>
LeastSquares<R>::~LeastSquares() = default;
template <Scalar R>
LeastSquares<R>::LeastSquares(LeastSquares&&) noexcept = default;
template <Scalar R>
LeastSquares<R>& LeastSquares<R>::operator=(LeastSquares&&) noexcept = default;

template <Scalar R>
int LeastSquares<R>::rank() const {
  return static_cast<int>(factors_->of_matrix.rank());
}

template <Scalar R>
Matrix<R> LeastSquares<R>::inverse() const {
  const Matrix<R> identity = Matrix<R>::Identity(factors_->of_matrix.rows(), factors_->of_matrix.rows());
  Matrix<R> inverse = factors_->of_matrix.solve(identity);
  inverse /= factors_->unit;
  return inverse;
}

template <Scalar R>
Matrix<R> LeastSquares<R>::solve(const Matrix<R>& right) const {
  const R unit = unit_of(right);
  const Matrix<R> in_units = right / unit;
  Matrix<R> solution = factors_->of_matrix.solve(in_units);
  solution *= R(unit / factors_->unit);
  return solution;
}

template <Scalar R>
Matrix<R> null_space(const Matrix<R>& matrix) {
  Eigen::ColPivHouseholderQR<Matrix<R>> factors;
  factors.setThreshold(R(1e-12));
  factors.compute(Matrix<R>(matrix.transpose()));
  const Matrix<R> orthogonal = factors.householderQ();
  return orthogonal.rightCols(matrix.cols() - factors.rank());
}

QrFactors qr_factors(const Matrix<double>& matrix, const Matrix<double>& right) {
  const Eigen::HouseholderQR<Matrix<double>> factors(matrix);
  QrFactors found{
      factors.matrixQR().topRows(std::min(matrix.rows(), matrix.cols())).template triangularView<Eigen::Upper>(),
      right};
  if (right.size() > 0) found.turned.applyOnTheLeft(factors.householderQ().adjoint());
  return found;
}

template <Scalar R>
SolvedSystem describe(std::string name, const Matrix<R>& matrix, int rank, const Matrix<R>& right,
                      const Matrix<R>& solution) {
  if constexpr (!std::same_as<R, double>) {
    return describe<double>(std::move(name), matrix.template cast<double>(), rank, right.template cast<double>(),
                            solution.template cast<double>());
  } else {
    // The triangle of a QR factorisation has the matrix's singular values, and is as small as they are many.
    const Matrix<double> in_units = matrix / unit_of(matrix);
    const Eigen::VectorXd values = Eigen::BDCSVD<Matrix<double>>(qr_factors(in_units).triangle).singularValues();
    const double least = values[values.size() - 1];
    const double unit = unit_of(right);
    const Eigen::VectorXd sizes = (right / unit).colwise().norm(),
                          left = ((matrix * solution - right) / unit).colwise().norm();
    double residual = 0;
    for (Eigen::Index k = 0; k < sizes.size(); ++k)
      if (sizes[k] > 0) residual = std::max(residual, left[k] / sizes[k]);
    return {.name = std::move(name),
            .rows = static_cast<int>(matrix.rows()),
            .columns = static_cast<int>(matrix.cols()),
            .rank = rank,
            .condition = least > 0 ? values[0] / least : std::numeric_limits<double>::infinity(),
            .residual = residual};
  }
}

template class LeastSquares<double>;
template class LeastSquares<Mp50>;
template class LeastSquares<Mp100>;
template Matrix<double> null_space<double>(const Matrix<double>&);
template Matrix<Mp50> null_space<Mp50>(const Matrix<Mp50>&);
template SolvedSystem describe<double>(std::string, const Matrix<double>&, int, const Matrix<double>&,
                                       const Matrix<double>&);
template SolvedSystem describe<Mp50>(std::string, const Matrix<Mp50>&, int, const Matrix<Mp50>&, const Matrix<Mp50>&);

}  // namespace cageproof
