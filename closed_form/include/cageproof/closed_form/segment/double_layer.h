// SPDX-License-Identifier: MIT
// The harmonic double layer of a segment's hat functions, the vertex part of Green coordinates of polygons.
#pragma once

#include "cageproof/closed_form/segment/engine/kernel.h"
#include "cageproof/closed_form/segment/engine/hat_integrals.h"

namespace cageproof::closed_form::segment {

/// phi_s^k = int Gamma_k x.n/(2 pi r^2) ([W12] Section 4.2, Appendix A after the errata): unitless; n the outward
/// normal. With lambda = ln(r1/r0) and alpha the angle under which the segment is seen (positive outside): phi^0 = (h
/// lambda - s1 alpha)/(2 pi length), phi^1 = (s0 alpha - h lambda)/(2 pi length). These are -Im F_k/(2 pi) of F_k = int
/// Gamma_k/z, whose derivatives give those with respect to the point. On the segment: the limit from inside, Gamma_k/2
/// within, a quarter for the hat function of an end at that end; at the ends derivatives have no limit: NaN. On the
/// segment's line beyond the ends the value is zero.
struct DoubleLayer {
  static constexpr int components = 2;

  /// Value and derivatives up to order O, in the caller's units.
  template <int O, class F, class R = typename F::Number>
  static Jet<R, 2, 2> at(const F& f) {
    Jet<R, 2, 2> jet;
    const R turn = 1 / (2 * pi<R>());
    const HatIntegrals<O, R> hats = hat_integrals<O>(f);
    for (int k = 0; k < 2; ++k) jet.value[k] = -turn * hats.inverse[k].im;
    if constexpr (O >= 1)
      for (int k = 0; k < 2; ++k)
        for (int i = 0; i < 2; ++i)
          jet.gradient[k][i] =
              f.at_end ? nan<R>()
                       : shifted<R>(-turn * (hats.square[k].im * f.u[i] + hats.square[k].re * f.n[i]), -f.exponent);
    if constexpr (O >= 2)
      for (int k = 0; k < 2; ++k) jet.hessian[k] = hessian(f, k, turn);
    return jet;
  }

 private:
  template <class R>
  static R nan() {
    return std::numeric_limits<R>::quiet_NaN();
  }

  template <Scalar R>
  static Eigen::Matrix<R, 2, 2> hessian(const Frame<R>& f, int k, const R& turn) {
    if (f.at_end) return Eigen::Matrix<R, 2, 2>::Constant(nan<R>());
    // F_k'' = length/(z_k^2 z_l): products, which cancel nothing. The far end goes first, so that no product is larger
    // than the result.
    const Complex<R> to_far = f.inverse(1 - f.near_end), to_near = f.inverse(f.near_end);
    const Complex<R> rest = k == f.near_end ? to_near : to_far;
    const Complex<R> second = (turn * shifted<R>(f.length, f.exponent) * to_far) * rest * to_near;
    return second.im * (f.n * f.n.transpose() - f.u * f.u.transpose()) -
           second.re * (f.u * f.n.transpose() + f.n * f.u.transpose());
  }
};

}  // namespace cageproof::closed_form::segment
