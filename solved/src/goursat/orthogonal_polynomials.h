// SPDX-License-Identifier: MIT
// Polynomials that are orthonormal over a set of points of the complex plane (Vandermonde with Arnoldi: Brubeck,
// Nakatsukasa, Trefethen 2021).
#pragma once

#include "goursat_jet.h"

#include <Eigen/Core>

#include <complex>
#include <span>
#include <vector>

namespace cageproof::solved::goursat {

/// q_0 = 1, q_1, ... of rising degree, in the mean over the points.
class OrthogonalPolynomials {
 public:
  /// \pre more points than `degree`
  OrthogonalPolynomials(std::span<const std::complex<double>> points, int degree);

  int degree() const { return static_cast<int>(recurrence_.cols()); }
  /// Each polynomial with its first two derivatives.
  template <class R>
  std::vector<std::array<Complex<R>, 3>> at(const Complex<R>& z) const;

 private:
  Eigen::MatrixXcd recurrence_;  // z q_j = sum of recurrence(i, j) q_i over i <= j + 1
};

}  // namespace cageproof::solved::goursat
