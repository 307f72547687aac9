// SPDX-License-Identifier: MIT
// Integrals of hat functions over powers of z far from a segment, where closed forms cancel: Gauss-Legendre points, as
// few as an error bound allows.
#pragma once

#include "cageproof/closed_form/segment/engine/frame.h"
#include "cageproof/core/gauss_legendre.h"

namespace cageproof::closed_form::segment {

/// Bound of the relative error of n points for the hat functions over z or z^2. The integrand is analytic within the
/// ellipse about the ends on which the point lies, whose half axes are (rho + 1/rho)/2 and (rho - 1/rho)/2 half
/// lengths, and the rule's error falls like rho^(-2n). One degree of those that the rule is exact for goes to the hat
/// function, and each power of 1/z may raise the integrand on a slightly smaller ellipse by n.
inline double far_error(int n, double rho) { return 4 * (1.0 + n) * (1.0 + n) * std::pow(rho, 1 - 2 * n); }

/// int Gamma_k/z and int Gamma_k/z^2 of both ends, in units of the frame. Every term has the sum's phase up to the
/// angle that the segment fills.
template <Scalar R>
struct FarSums {
  std::array<Complex<R>, 2> inverse{}, square{};

  /// \pre f.is_far()
  explicit FarSums(const Frame<R>& f) {
    const double sum = static_cast<double>((f.r[0] + f.r[1]) / f.length), rho = sum + std::sqrt(sum * sum - 1);
    int n = 2;
    while (far_error(n, rho) > 0x1p-55) ++n;
    const auto& [nodes, weights] = gauss_legendre<R>(n);
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

}  // namespace cageproof::closed_form::segment
