// SPDX-License-Identifier: MIT
// The mean value weights of a triangle.
#pragma once

#include "cageproof/closed_form/triangle/engine/kernel.h"

namespace cageproof::closed_form::triangle {

/// w_t^k = int Gamma_k x.n/r^4, the unnormalised mean value weights ([T18] Eq 11; equal to Eq 12-14): 1/length. On the
/// triangle they diverge: infinite where the hat function is positive, NaN where it is zero, and their ratios tend to
/// the hat functions. In the plane outside it they are zero.
struct MeanValue : EvenPowers {
  static constexpr int components = 3, degree = -1, border_order = 0, far_power = -4;
  template <class S, class R, int N>
  static void compose(const S& s, std::span<const R>, std::array<Taylor<R, N>, 3>& out) {
    const auto& w = s.mean_value();
    for (int k = 0; k < 3; ++k) out[k].add(R(1), w[k]);
  }
};

}  // namespace cageproof::closed_form::triangle
