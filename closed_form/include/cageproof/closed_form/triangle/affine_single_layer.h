// SPDX-License-Identifier: MIT
// The single layer of the hat functions.
#pragma once

#include "cageproof/closed_form/arithmetic/constants.h"
#include "cageproof/closed_form/triangle/engine/kernel.h"

namespace cageproof::closed_form::triangle {

/// psi_t^k = int Gamma_k/(4 pi r), the single layer of the hat functions ([T24] Eq 43-46; edge form): a length. As
/// psi_t on the triangle.
struct AffineSingleLayer : OddPowers {
  static constexpr int components = 3, degree = 1, border_order = 1, far_power = -1;
  static constexpr OnBorder on_border = OnBorder::Logarithm;
  // The hat functions' shares of the near form cancel where these grow: three quarters of a size away a gradient may
  // lose 66 roundings.
  static constexpr int far_limit = 28;
  template <class S, class R, int N>
  static void compose(const S& s, std::span<const R>, std::array<Taylor<R, N>, 3>& out) {
    const auto& a = s.A();
    for (int k = 0; k < 3; ++k) out[k].add(R(1) / (R(4) * constant_pi<R>()), a[k]);
  }
};

}  // namespace cageproof::closed_form::triangle
