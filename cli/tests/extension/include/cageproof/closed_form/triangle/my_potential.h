// SPDX-License-Identifier: MIT
// Third edit: the closed form, from a triangle's moments.
#pragma once

#include "cageproof/closed_form/triangle/engine/kernel.h"

namespace cageproof::closed_form::triangle {

/// int 1/r: a length. Finite everywhere; on the border the gradient is infinite.
struct MyPotential : OddPowers {
  static constexpr int components = 1, degree = 1, border_order = 1, far_power = -1;
  static constexpr OnBorder on_border = OnBorder::Logarithm;
  template <class S, class R, int N>
  static void compose(const S& moments, std::span<const R>, std::array<Taylor<R, N>, 1>& out) {
    out[0].add(R(1), moments.J());
  }
};

}  // namespace cageproof::closed_form::triangle
