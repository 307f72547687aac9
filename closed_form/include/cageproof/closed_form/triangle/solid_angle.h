// SPDX-License-Identifier: MIT
// The solid angle of a triangle.
#pragma once

#include "cageproof/closed_form/triangle/engine/kernel.h"

namespace cageproof::closed_form::triangle {

/// omega_t = int x.n/r^3, the solid angle ([T24] Appendix A, sign after the errata; edge form): in (-2 pi, 2 pi],
/// positive inside a cage. On the triangle: the limit from inside, 2 pi within, pi on an edge, the corner's angle at a
/// corner.
struct SolidAngle : OddPowers {
  static constexpr int components = 1, degree = 0, border_order = 1, far_power = -3;
  /// The Hessian is zero over one point of every triangle (the centre, if it is equilateral), where its terms are of
  /// this size, in the longest edge's units.
  static constexpr double terms_of_hessian = 32;
  template <class S, class R, int N>
  static void compose(const S& s, std::span<const R>, std::array<Taylor<R, N>, 1>& out) {
    out[0].add(R(1), s.omega());
  }
};

}  // namespace cageproof::closed_form::triangle
