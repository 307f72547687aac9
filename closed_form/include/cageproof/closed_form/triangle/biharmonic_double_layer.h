// SPDX-License-Identifier: MIT
// The biharmonic double layer of the hat functions.
#pragma once

#include "cageproof/closed_form/arithmetic/constants.h"
#include "cageproof/closed_form/triangle/engine/kernel.h"

namespace cageproof::closed_form::triangle {

/// phibar_t^k = int -Gamma_k x.n/(8 pi r) = d psi_t^k/2 ([T24] Eq 15-18; edge form): an area. Zero in the triangle's
/// plane, with a finite gradient everywhere; on the border the Hessian is infinite where the logarithm of the distance
/// enters it, and NaN elsewhere.
struct BiharmonicDoubleLayer : OddPowers {
  static constexpr int components = 3, degree = 2, border_order = 2, far_power = -1;
  static constexpr OnBorder on_border = OnBorder::LogarithmAndDirection;
  // Straight above the triangle the gradient of x.n/r is less than its terms by the square of the distance.
  static constexpr bool cancels_far = true;
  /// Next to the triangle's plane the Hessian is as small as the solid angle, and its terms are some of this size.
  static constexpr double terms_of_hessian = 0.1;
  template <class S, class R, int N>
  static void compose(const S& s, std::span<const R>, std::array<Taylor<R, N>, 3>& out) {
    const auto& a = s.A();
    const R c = R(1) / (R(8) * constant_pi<R>());
    const auto& n = s.frame().n;
    for (int k = 0; k < 3; ++k) out[k].add_linear(c * s.frame().d, Vec3<R>(c * n[0], c * n[1], c * n[2]), a[k]);
  }
};

}  // namespace cageproof::closed_form::triangle
