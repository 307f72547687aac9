// SPDX-License-Identifier: MIT
// The potential of a triangle with unit charge.
#pragma once

#include "cageproof/closed_form/arithmetic/constants.h"
#include "cageproof/closed_form/triangle/engine/kernel.h"

namespace cageproof::closed_form::triangle {

/// psi_t = int 1/(4 pi r) ([T24] Eq 5; edge form): a length. Finite everywhere; on the triangle its gradient is the
/// limit from inside, on the border infinite against the edges' outward normals.
struct SingleLayer : OddPowers {
  static constexpr int components = 1, degree = 1, border_order = 1, far_power = -1;
  static constexpr OnBorder on_border = OnBorder::Logarithm;
  template <class S, class R, int N>
  static void compose(const S& s, std::span<const R>, std::array<Taylor<R, N>, 1>& out) {
    out[0].add(R(1) / (R(4) * constant_pi<R>()), s.J());
  }
};

}  // namespace cageproof::closed_form::triangle
