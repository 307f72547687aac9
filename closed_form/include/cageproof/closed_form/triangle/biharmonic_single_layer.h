// SPDX-License-Identifier: MIT
// The biharmonic single layer of a triangle.
#pragma once

#include "cageproof/closed_form/arithmetic/constants.h"
#include "cageproof/closed_form/triangle/engine/kernel.h"

namespace cageproof::closed_form::triangle {

/// psibar_t = int r/(8 pi) ([T24] Eq 9-14; edge form): a volume. Finite everywhere with its gradient and Hessian.
struct BiharmonicSingleLayer : OddPowers {
  static constexpr int components = 1, degree = 3, border_order = 3, far_power = 1;
  /// The gradient is zero in the plane, at one point of every triangle, where its terms are of this size, in the
  /// longest edge's units.
  static constexpr double terms_of_gradient = 0.02;
  template <class S, class R, int N>
  static void compose(const S& s, std::span<const R>, std::array<Taylor<R, N>, 1>& out) {
    out[0].add(R(1) / (R(8) * constant_pi<R>()), s.I());
  }
};

}  // namespace cageproof::closed_form::triangle
