// SPDX-License-Identifier: MIT
// The polyharmonic double layer of a segment's hat functions in the plane.
#pragma once

#include "cageproof/closed_form/segment/biharmonic_double_layer.h"
#include "cageproof/closed_form/segment/double_layer.h"
#include "cageproof/closed_form/segment/engine/radial_moments.h"

namespace cageproof::closed_form::segment {

/// int Gamma_k dG_s/dn with G_s as in the polyharmonic single layer ([W12] Appendix B after the errata): the power
/// 2 s - 2 of a length, from s = 2 on times the logarithm of one. Parameter s = 1 ... 6: for 1 phi_s^k, for 2
/// phibar_s^k; its Laplacian is that of s - 1. x.n = -h all along, so that with g1 = G_s'/r, g2 = g1'/r, g3 = g2'/r and
/// x = s u - h n
///   value -h g1, gradient -g1 n + h g2 x, Hessian g2 (n x' + x n') - h (g2 I + g3 x x'),
/// integrated with the hat function. From s = 3 on everything has a limit on the segment and at its ends.
struct PolyharmonicDoubleLayer {
  static constexpr int components = 2, parameter_count = 1;
  static constexpr bool has_signs_at_ends = true;
  static LogarithmicPart logarithmic_part(std::span<const double> parameters) {
    const Radial<double> g1 = polyharmonic_green_function<double>(static_cast<int>(parameters[0])).next();
    return {g1.log / (2 * pi<double>()), 2 * g1.power + 1, true};
  }

  /// Value and derivatives up to order O, in the caller's units.
  template <int O, class F, class R = typename F::Number>
  static Jet<R, 2, 2> at(const F& f, const Given<R>& given) {
    const int order = static_cast<int>(static_cast<double>(given.parameters[0]));
    if (order == 1) return DoubleLayer::at<O>(f);
    if (order == 2) return BiharmonicDoubleLayer::at<O>(f);
    Jet<R, 2, 2> jet;
    const R turn = 1 / (2 * pi<R>());
    const Radial<R> g1 = polyharmonic_green_function<R>(order).next(), g2 = g1.next(), g3 = g2.next();
    const auto m = radial_moments(f, 2 * g1.power + 1);
    const int unit = (2 * order - 2) * f.exponent;
    for (int k = 0; k < 2; ++k) {
      const auto part = [&](int i, const Radial<R>& g, int power) { return m.integral_of_hat(k, i, g, power); };
      jet.value[k] = shifted<R>(-turn * part(0, g1, 1), unit);
      if constexpr (O >= 1) {
        const R along = turn * part(1, g2, 1), across = -turn * (part(0, g1, 0) + part(0, g2, 2));
        for (int i = 0; i < 2; ++i)
          jet.gradient[k][i] = shifted<R>(along * f.u[i] + across * f.n[i], unit - f.exponent);
      }
      if constexpr (O >= 2) {
        const R lift = part(0, g2, 1), uu = -lift - part(2, g3, 1), nn = -3 * lift - part(0, g3, 3),
                un = part(1, g2, 0) + part(1, g3, 2);
        for (int i = 0; i < 2; ++i)
          for (int j = 0; j < 2; ++j)
            jet.hessian[k](i, j) = shifted<R>(
                turn * (uu * f.u[i] * f.u[j] + nn * f.n[i] * f.n[j] + un * (f.u[i] * f.n[j] + f.n[i] * f.u[j])),
                unit - 2 * f.exponent);
      }
    }
    return jet;
  }
};

}  // namespace cageproof::closed_form::segment
