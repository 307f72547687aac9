// SPDX-License-Identifier: MIT
// Kelvin's tractions weighted with the hat functions, the vertex part of Somigliana coordinates.
#pragma once

#include "cageproof/closed_form/arithmetic/constants.h"
#include "cageproof/closed_form/triangle/engine/kernel.h"
#include "cageproof/closed_form/arithmetic/kelvin_shares.h"

namespace cageproof::closed_form::triangle {

/// The limit from inside of d Hess J on the triangle's border, which the edge form leaves out there: K3 d^2 and S3 |d|
/// of the edges that the point lies on do not vanish. Zero elsewhere.
template <class R>
std::array<R, 9> border_height_hessian(const Frame<R>& f) {
  std::array<R, 9> m{};
  for (const FrameEdge<R>& e : f.edges) {
    if (!on_edge(e)) continue;
    const bool starts = e.r0 == R(0), ends = e.r1 == R(0);
    const R across(starts || ends ? 1 : 2);
    const R along = R(starts ? 1 : ends ? -1 : 0) / R(2);
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j)
        m[3 * i + j] += across * (f.n[i] * e.nu[j] + e.nu[i] * f.n[j]) + along * (e.nu[i] * e.u[j] + e.u[i] * e.nu[j]);
  }
  return m;
}

/// T_t^k = int Gamma_k mu ((a-2b)(x.n I + n x' - x n')/r^3 + 6b x.n x x'/r^5)
///       = mu (a B I + (a - 2b)(n (grad A)' - (grad A) n') - 2b d Hess A), row by row ([T24] Eq 47-49 with the factor
///       mu of the errata, [C23]
/// Eq 4; edge form): unitless, independent of mu. Parameters as K_t. On the triangle: the limit from inside; on its
/// border the entries that the logarithm of the distance enters are infinite, the others limits from inside. Summed
/// over a closed cage the logarithms cancel.
struct KelvinTraction : OddPowers {
  static constexpr int components = 27, degree = 0, extra = 2, parameter_count = 2, border_order = 0, far_power = -3;
  static constexpr OnBorder on_border = OnBorder::Logarithm;
  /// Next to the triangle's plane the value is as small as the solid angle, and its terms are some of this size.
  static constexpr double terms_of_value = 0.1;
  template <class S, class R, int N>
  static void compose(const S& s, std::span<const R> parameters, std::array<Taylor<R, N>, 27>& out) {
    const KelvinShares<R> shares(parameters[1]);
    const R c = R(1) / (R(4) * constant_pi<R>());
    const R shear = c * shares.shear, bulk = -c * shares.bulk;
    const auto& n = s.frame().n;
    const Vec3<R> tilt(bulk * n[0], bulk * n[1], bulk * n[2]);
    const auto& a = s.A();
    const auto& b = s.B();
    const std::array<R, 9> border = border_height_hessian(s.frame());
    for (int k = 0; k < 3; ++k) {
      const std::array slope{derivative(a[k], 0), derivative(a[k], 1), derivative(a[k], 2)};
      for (int row = 0; row < 3; ++row)
        for (int column = 0; column < 3; ++column) {
          Taylor<R, N>& entry = out[9 * k + 3 * row + column];
          entry.c[0] += bulk * s.frame().hat(k) * border[3 * row + column];
          entry.add_linear(bulk * s.frame().d, tilt, derivative(slope[row], column));
          if (row == column) {
            entry.add(c, b[k]);
          } else {
            entry.add(shear * n[row], slope[column]);
            entry.add(-shear * n[column], slope[row]);
          }
        }
    }
  }
};

}  // namespace cageproof::closed_form::triangle
