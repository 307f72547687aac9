// SPDX-License-Identifier: MIT
// The polyharmonic potential of a segment with unit charge in the plane.
#pragma once

#include "cageproof/closed_form/segment/biharmonic_single_layer.h"
#include "cageproof/closed_form/segment/engine/radial_moments.h"
#include "cageproof/closed_form/segment/single_layer.h"

namespace cageproof::closed_form::segment {

/// int -G_s with G_s = r^(2(s - 1)) (a_s ln r - b_s)/(2 pi) ([W12] Appendix B, exponent and b_i after the errata): the
/// power 2 s - 1 of a length times the logarithm of one. Parameter s = 1 ... 6: for 1 psi_s, for 2 psibar_s; its
/// Laplacian is that of s - 1. From s = 2 on everything has a limit on the segment and at its ends.
struct PolyharmonicSingleLayer {
  static constexpr int components = 1, parameter_count = 1;
  static LogarithmicPart logarithmic_part(std::span<const double> parameters) {
    const Radial<double> g = polyharmonic_green_function<double>(static_cast<int>(parameters[0]));
    return {g.log / (2 * pi<double>()), 2 * g.power};
  }

  /// Value and derivatives up to order O, in the caller's units.
  template <int O, class F, class R = typename F::Number>
  static Jet<R, 1, 2> at(const F& f, const Given<R>& given) {
    const int order = static_cast<int>(static_cast<double>(given.parameters[0]));
    if (order == 1) return SingleLayer::at<O>(f);
    if (order == 2) return BiharmonicSingleLayer::at<O>(f);
    Jet<R, 1, 2> jet;
    const R turn = 1 / (2 * pi<R>());
    const Radial<R> g = polyharmonic_green_function<R>(order), g1 = g.next();
    const auto m = radial_moments(f, 2 * g.power);
    const int unit = (2 * order - 1) * f.exponent;
    jet.value[0] = shifted<R>(-turn * m.integral(0, g, 0), unit);
    if constexpr (O >= 1) {
      const R along = turn * m.integral(1, g1, 0), across = -turn * m.integral(0, g1, 1);
      for (int i = 0; i < 2; ++i) jet.gradient[0][i] = shifted<R>(along * f.u[i] + across * f.n[i], unit - f.exponent);
    }
    if constexpr (O >= 2) {
      const Radial<R> g2 = g1.next();
      const R round = m.integral(0, g1, 0), uu = round + m.integral(2, g2, 0), un = -m.integral(1, g2, 1),
              nn = round + m.integral(0, g2, 2);
      for (int i = 0; i < 2; ++i)
        for (int j = 0; j < 2; ++j)
          jet.hessian[0](i, j) = shifted<R>(
              -turn * (uu * f.u[i] * f.u[j] + nn * f.n[i] * f.n[j] + un * (f.u[i] * f.n[j] + f.n[i] * f.u[j])),
              unit - 2 * f.exponent);
    }
    return jet;
  }
};

}  // namespace cageproof::closed_form::segment
