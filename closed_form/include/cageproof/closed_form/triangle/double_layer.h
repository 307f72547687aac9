// SPDX-License-Identifier: MIT
// The harmonic double layer of the hat functions, the vertex part of Green coordinates.
#pragma once

#include "cageproof/closed_form/arithmetic/constants.h"
#include "cageproof/closed_form/triangle/engine/kernel.h"

namespace cageproof::closed_form::triangle {

/// phi_t^k = int Gamma_k x.n/(4 pi r^3), the harmonic double layer of the three hat functions ([T24] Eq 5; edge form):
/// unitless. On the triangle: the limit from inside, Gamma_k/2 within; derivatives have no limit on the border. The
/// gradient is that of this one triangle's phi; the "curl form" is right only when summed over a closed cage.
struct DoubleLayer : OddPowers {
  static constexpr int components = 3, degree = 0, border_order = 1, far_power = -3;
  template <class S, class R, int N>
  static void compose(const S& s, std::span<const R>, std::array<Taylor<R, N>, 3>& out) {
    const auto& b = s.B();
    for (int k = 0; k < 3; ++k) out[k].add(R(1) / (R(4) * constant_pi<R>()), b[k]);
  }
};

}  // namespace cageproof::closed_form::triangle
