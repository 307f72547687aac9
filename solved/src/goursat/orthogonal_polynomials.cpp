// SPDX-License-Identifier: MIT
#include "orthogonal_polynomials.h"

namespace cageproof::solved::goursat {

OrthogonalPolynomials::OrthogonalPolynomials(std::span<const std::complex<double>> points, int degree)
    : recurrence_(Eigen::MatrixXcd::Zero(degree + 1, degree)) {
  const auto count = static_cast<Eigen::Index>(points.size());
  const Eigen::Map<const Eigen::VectorXcd> z(points.data(), count);
  Eigen::MatrixXcd q(count, degree + 1);
  q.col(0).setOnes();
  for (int j = 0; j < degree; ++j) {
    Eigen::VectorXcd next = z.cwiseProduct(q.col(j));
    // Twice, so that rounding leaves them orthogonal.
    for (int pass = 0; pass < 2; ++pass) {
      const Eigen::VectorXcd shares = q.leftCols(j + 1).adjoint() * next / static_cast<double>(count);
      next -= q.leftCols(j + 1) * shares;
      recurrence_.col(j).head(j + 1) += shares;
    }
    const double length = next.norm() / std::sqrt(static_cast<double>(count));
    recurrence_(j + 1, j) = length;
    q.col(j + 1) = next / length;
  }
}

template <class R>
std::vector<std::array<Complex<R>, 3>> OrthogonalPolynomials::at(const Complex<R>& z) const {
  std::vector<std::array<Complex<R>, 3>> q(degree() + 1);
  q[0] = {Complex<R>(R(1)), Complex<R>(), Complex<R>()};
  for (int j = 0; j < degree(); ++j) {
    std::array<Complex<R>, 3> next{z * q[j][0], z * q[j][1] + q[j][0], z * q[j][2] + R(2) * q[j][1]};
    for (int i = 0; i <= j; ++i) {
      const Complex<R> share{R(recurrence_(i, j).real()), R(recurrence_(i, j).imag())};
      for (int o = 0; o < 3; ++o) next[o] = next[o] - share * q[i][o];
    }
    const R inverse = R(1) / R(recurrence_(j + 1, j).real());
    for (int o = 0; o < 3; ++o) q[j + 1][o] = inverse * next[o];
  }
  return q;
}

template std::vector<std::array<Complex<double>, 3>> OrthogonalPolynomials::at(const Complex<double>&) const;
template std::vector<std::array<Complex<Mp50>, 3>> OrthogonalPolynomials::at(const Complex<Mp50>&) const;
template std::vector<std::array<Complex<Mp100>, 3>> OrthogonalPolynomials::at(const Complex<Mp100>&) const;

}  // namespace cageproof::solved::goursat
