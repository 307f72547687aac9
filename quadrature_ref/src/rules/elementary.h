// SPDX-License-Identifier: MIT
// Functions that the standard library or Boost.Multiprecision lacks at some precision.
#pragma once

#include "cageproof/core/numbers/scalar.h"

#include <cmath>
#include <numbers>
#include <vector>

namespace cageproof::quadrature_ref {

template <Scalar R>
R inverse_sinh(const R& x) {
  if constexpr (is_multiprecision<R>) {
    R y;
    mpfr_asinh(y.data(), x.data(), MPFR_RNDN);
    return y;
  } else {
    return std::asinh(x);
  }
}

template <Scalar R>
void sinh_cosh(const R& x, R& sinh_x, R& cosh_x) {
  if constexpr (is_multiprecision<R>) {
    mpfr_sinh_cosh(sinh_x.data(), cosh_x.data(), x.data(), MPFR_RNDN);
  } else {
    sinh_x = std::sinh(x);
    cosh_x = std::cosh(x);
  }
}

/// log10 |x| for any exponent; minus infinity for 0.
template <Scalar R>
double log10_magnitude(const R& x) {
  if constexpr (is_multiprecision<R>) {
    if (x == 0) return -std::numeric_limits<double>::infinity();
    long exponent = 0;
    const double mantissa = mpfr_get_d_2exp(&exponent, x.data(), MPFR_RNDN);
    return std::log10(std::abs(mantissa)) + static_cast<double>(exponent) * 0.30102999566398119521;
  } else {
    return std::log10(std::abs(x));
  }
}

/// ln |x| for any exponent; minus infinity for 0.
template <Scalar R>
double log_magnitude(const R& x) {
  return log10_magnitude(x) * std::numbers::ln10;
}

/// asinh(exp(x)), also where exp(x) leaves double's range.
inline double asinh_of_exp(double x) { return x > 30 ? x + std::numbers::ln2 : std::asinh(std::exp(x)); }

/// log10 of the square root of the sum of squares.
template <Scalar R>
double log10_norm(const std::vector<R>& tensor) {
  R square = 0;
  for (const R& entry : tensor) square += entry * entry;
  return log10_magnitude(square) / 2;
}

}  // namespace cageproof::quadrature_ref
