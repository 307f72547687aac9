// SPDX-License-Identifier: MIT
// Kelvin's displacements of a triangle, the normal part of Somigliana coordinates.
#pragma once

#include "cageproof/closed_form/arithmetic/constants.h"
#include "cageproof/closed_form/triangle/engine/kernel.h"
#include "cageproof/closed_form/arithmetic/kelvin_shares.h"

namespace cageproof::closed_form::triangle {

/// K_t = int (a - b)/r I + b x x'/r^3 = a J I - b Hess I, row by row ([T24] Eq 47-49, [C23] Eq 3; edge form): a length
/// over a modulus. Parameters mu > 0 and nu < 1/2, with the limits 1/2 and +-infinity. Finite everywhere; on the border
/// the gradient is infinite where the logarithm of the distance enters it, and NaN elsewhere.
struct KelvinDisplacement : OddPowers {
  static constexpr int components = 9, degree = 1, extra = 2, parameter_count = 2, border_order = 1, far_power = -1;
  static constexpr OnBorder on_border = OnBorder::LogarithmAndDirection;
  template <class S, class R, int N>
  static void compose(const S& s, std::span<const R> parameters, std::array<Taylor<R, N>, 9>& out) {
    const R a = R(1) / (R(4) * constant_pi<R>() * parameters[0]);
    const R b = a * KelvinShares<R>(parameters[1]).bulk / R(2);
    const auto& j = s.J();
    const auto& i = s.I();
    for (int row = 0; row < 3; ++row) {
      const auto slope = derivative(i, row);
      for (int column = row; column < 3; ++column) {
        Taylor<R, N>& entry = out[3 * row + column];
        entry.add(-b, derivative(slope, column));
        if (row == column) entry.add(a, j);
        out[3 * column + row] = entry;
      }
    }
  }
};

}  // namespace cageproof::closed_form::triangle
