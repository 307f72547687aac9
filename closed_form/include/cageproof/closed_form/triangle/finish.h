// SPDX-License-Identifier: MIT
#pragma once

#include "cageproof/closed_form/jet.h"

#include <cmath>
#include <limits>

namespace cageproof::closed_form {

/// Brings a jet from frame units back to the caller's: order k of a formula of degree m scales with unit^(m - k).
/// Orders from `first_divergent` on have no limit here (the point is on the border) and become NaN.
template <Scalar R, int C>
Jet<R, C> finish(Jet<R, C> jet, int degree, const R& unit, int first_divergent = 3) {
  const auto power = [&unit](int exponent) {
    if constexpr (is_multiprecision<R>) return R(1);
    else return R(std::ldexp(R(1), exponent * std::ilogb(unit)));
  };
  const R nan = std::numeric_limits<R>::quiet_NaN();
  const R scale0 = power(degree), scale1 = power(degree - 1), scale2 = power(degree - 2);
  for (int c = 0; c < C; ++c) {
    jet.value[c] *= scale0;
    if (first_divergent <= 1) jet.gradient[c].setConstant(nan);
    else jet.gradient[c] *= scale1;
    if (first_divergent <= 2) jet.hessian[c].setConstant(nan);
    else jet.hessian[c] *= scale2;
  }
  return jet;
}

}  // namespace cageproof::closed_form
