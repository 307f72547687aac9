// SPDX-License-Identifier: MIT
// Value, gradient and Hessian of a few scalars at one point.
#pragma once

#include "cageproof/core/numbers/scalar_names.h"
#include "cageproof/core/numbers/vector.h"

#include <array>

namespace cageproof::closed_form {

/// C scalars with their derivatives with respect to the point, in the D coordinates of the space; what lies above the
/// order asked for is zero.
template <class R, int C, int D = 3>
struct Jet {
  using Gradient = Eigen::Matrix<R, D, 1>;
  using Hessian = Eigen::Matrix<R, D, D>;

  std::array<R, C> value;
  std::array<Gradient, C> gradient;
  std::array<Hessian, C> hessian;

  Jet() {
    value.fill(R(0));
    gradient.fill(Gradient::Zero());
    hessian.fill(Hessian::Zero());
  }
};

/// The jet in a narrower type.
template <Scalar To, Scalar From, int C, int D>
Jet<To, C, D> narrowed(const Jet<From, C, D>& from) {
  Jet<To, C, D> to;
  for (int c = 0; c < C; ++c) {
    to.value[c] = static_cast<To>(from.value[c]);
    for (int i = 0; i < D; ++i) to.gradient[c][i] = static_cast<To>(from.gradient[c][i]);
    for (int i = 0; i < D; ++i)
      for (int j = 0; j < D; ++j) to.hessian[c](i, j) = static_cast<To>(from.hessian[c](i, j));
  }
  return to;
}

}  // namespace cageproof::closed_form
