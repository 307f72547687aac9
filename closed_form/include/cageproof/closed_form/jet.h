// SPDX-License-Identifier: MIT
// Value, gradient and Hessian of a few scalars at one point.
#pragma once

#include "cageproof/core/evaluation.h"

#include <array>

namespace cageproof::closed_form {

/// C scalars with their derivatives with respect to the point; what lies above the order asked for is zero.
template <Scalar R, int C>
struct Jet {
  std::array<R, C> value;
  std::array<Vec3<R>, C> gradient;
  std::array<Mat3<R>, C> hessian;

  Jet() {
    value.fill(R(0));
    gradient.fill(Vec3<R>::Zero());
    hessian.fill(Mat3<R>::Zero());
  }
};

/// The jet in a narrower type.
template <Scalar To, Scalar From, int C>
Jet<To, C> narrowed(const Jet<From, C>& from) {
  Jet<To, C> to;
  for (int c = 0; c < C; ++c) {
    to.value[c] = static_cast<To>(from.value[c]);
    to.gradient[c] = convert<To>(from.gradient[c]);
    to.hessian[c] = from.hessian[c].template cast<To>();
  }
  return to;
}

/// Copies a jet into an evaluation's result, orders 0 to `order`.
template <Scalar R, int C>
void store(const Jet<R, C>& jet, int order, Result<R>& result) {
  result.reset(C, 3, order);
  for (int c = 0; c < C; ++c) {
    result.value[c] = jet.value[c];
    for (int i = 0; order >= 1 && i < 3; ++i) result.gradient[3 * c + i] = jet.gradient[c][i];
    for (int i = 0; order >= 2 && i < 3; ++i)
      for (int j = 0; j < 3; ++j) result.hessian[9 * c + 3 * i + j] = jet.hessian[c](i, j);
  }
}

}  // namespace cageproof::closed_form
