// SPDX-License-Identifier: MIT
// Integrals of hat functions over powers of z, and times its logarithm, far from a segment, where closed forms cancel:
// Gauss-Legendre points, as few as an error bound allows.
#pragma once

#include "cageproof/closed_form/segment/engine/frame.h"

namespace cageproof::closed_form::segment {

/// log10 of a bound of the relative error of n points for the hat functions over z or z^2. The integrand is analytic
/// within the ellipse about the ends on which the point lies, whose half axes are (rho + 1/rho)/2 and (rho - 1/rho)/2
/// half lengths, and the rule's error falls like rho^(-2n). One degree of those that the rule is exact for goes to the
/// hat function, and each power of 1/z may raise the integrand on a slightly smaller ellipse by n.
inline double log10_far_error(int n, double rho) {
  return std::log10(4 * (1.0 + n) * (1.0 + n)) - (2 * n - 1) * std::log10(rho);
}

/// The fewest points for a quarter of a rounding. \pre f.is_for_sums()
template <Scalar R>
int far_points(const Frame<R>& f) {
  const double sum = static_cast<double>((f.r[0] + f.r[1]) / f.length), rho = sum + std::sqrt(sum * sum - 1);
  int n = 2;
  const double rounding = is_multiprecision<R> ? -std::numeric_limits<R>::digits10 : std::log10(0x1p-55);
  while (log10_far_error(n, rho) > rounding) ++n;
  return n;
}

/// int Gamma_k/z and int Gamma_k/z^2 of both ends, in units of the frame. Every term has the sum's phase up to the
/// angle that the segment fills.
template <Scalar R>
struct FarSums {
  std::array<Complex<R>, 2> inverse{}, square{};

  /// \pre f.is_for_sums()
  explicit FarSums(const Frame<R>& f) {
    const auto& [nodes, weights] = gauss_legendre<R>(far_points(f));
    for (std::size_t j = 0; j < nodes.size(); ++j) {
      const R along = f.s[0] + f.length * nodes[j], square_of_r = along * along + f.h * f.h;
      const Complex<R> q{along / square_of_r, f.h / square_of_r}, q2 = q * q;
      const std::array<R, 2> hat{1 - nodes[j], nodes[j]};
      for (int k = 0; k < 2; ++k) {
        const R weight = weights[j] * f.length * hat[k];
        inverse[k] = inverse[k] + weight * q;
        square[k] = square[k] + weight * q2;
      }
    }
  }
};

/// int Gamma_k ln r of both ends, in units of the frame.
template <Scalar R>
struct FarLogarithms {
  std::array<R, 2> hats{};

  /// \pre f.is_for_sums()
  explicit FarLogarithms(const Frame<R>& f) {
    using std::log;
    const auto& [nodes, weights] = gauss_legendre<R>(far_points(f));
    for (std::size_t j = 0; j < nodes.size(); ++j) {
      const R along = f.s[0] + f.length * nodes[j];
      const R logarithm = weights[j] * f.length / 2 * log(R(along * along + f.h * f.h));
      hats[0] += (1 - nodes[j]) * logarithm;
      hats[1] += nodes[j] * logarithm;
    }
  }
};

/// Of r^2 (ln r - 1) and of its derivatives over the segment, in units of the frame.
template <Scalar R>
struct FarSquareLogarithm {
  R value{};            ///< int r^2 (ln r - 1)
  R along{}, across{};  ///< int x (2 ln r - 1) along the segment and its normal

  /// \pre f.is_for_sums()
  explicit FarSquareLogarithm(const Frame<R>& f) {
    using std::log;
    const auto& [nodes, weights] = gauss_legendre<R>(far_points(f));
    for (std::size_t j = 0; j < nodes.size(); ++j) {
      const R s = f.s[0] + f.length * nodes[j], square = s * s + f.h * f.h, logarithm = log(square);
      const R weight = weights[j] * f.length;
      value += weight * square * (logarithm / 2 - 1);
      along += weight * s * (logarithm - 1);
      across -= weight * f.h * (logarithm - 1);
    }
  }
};

}  // namespace cageproof::closed_form::segment
