// SPDX-License-Identifier: MIT
#pragma once

#include "cageproof/core/numbers/scalar.h"

#include <cmath>
#include <limits>

namespace cageproof::quadrature_ref {

/// Multiplies by 2^exponent with the rounding of ldexp. Where the factor is a normal number one product does it; a call
/// of ldexp costs as much as a node.
template <Scalar R>
class PowerOfTwo {
 public:
  explicit PowerOfTwo(int exponent) : exponent_(exponent) {
    if constexpr (!is_multiprecision<R>) {
      is_factor_ = exponent > std::numeric_limits<R>::min_exponent && exponent < std::numeric_limits<R>::max_exponent;
      if (is_factor_) factor_ = std::ldexp(R(1), exponent);
    }
  }
  R operator()(const R& x) const {
    using std::ldexp;
    if constexpr (!is_multiprecision<R>)
      if (is_factor_) return x * factor_;
    return ldexp(x, exponent_);
  }

 private:
  int exponent_;
  bool is_factor_ = false;
  R factor_{};
};

}  // namespace cageproof::quadrature_ref
