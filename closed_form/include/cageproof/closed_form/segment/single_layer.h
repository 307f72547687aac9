// SPDX-License-Identifier: MIT
// The potential of a segment with unit charge in the plane, the normal part of Green coordinates of polygons.
#pragma once

#include "cageproof/closed_form/arithmetic/jet.h"
#include "cageproof/closed_form/segment/engine/kernel.h"
#include "cageproof/closed_form/segment/engine/logarithms.h"

namespace cageproof::closed_form::segment {

/// psi_s = int -ln r/(2 pi) ([W12] Section 4.2 with the plane's G1): a length times the logarithm of one, so that it
/// depends on the unit of length; its gradient has no unit, its Hessian is 1/length. With lambda = ln(r1/r0), alpha the
/// angle under which the segment is seen (positive outside):
///   psi = -(s1 ln r1 - s0 ln r0 - length + h alpha)/(2 pi),  grad psi = (u lambda - n alpha)/(2 pi).
/// Value and tangential derivative are continuous across the segment; the normal derivative is 1/2 just inside and -1/2
/// just outside. On the segment: the limit from inside. At its ends the value has a limit; the gradient is infinite
/// along the segment, with its sign, in all coordinates along which the segment extends, the limit from inside in the
/// others; the Hessian has none: NaN.
struct SingleLayer {
  static constexpr int components = 1;
  static LogarithmicPart logarithmic_part(std::span<const double>) { return {1 / (2 * pi<double>()), 0}; }

  /// Value and derivatives up to order O, in the caller's units.
  template <int O, class F, class R = typename F::Number>
  static Jet<R, 1, 2> at(const F& f) {
    Jet<R, 1, 2> jet;
    const R turn = 1 / (2 * pi<R>());
    jet.value[0] = shifted<R>(-turn * (integral_of_logarithm(f) + f.length * unit_logarithm(f)), f.exponent);
    if constexpr (O >= 1) jet.gradient[0] = gradient(f, turn);
    if constexpr (O >= 2) jet.hessian[0] = hessian(f, turn);
    return jet;
  }

 private:
  template <Scalar R>
  static Eigen::Matrix<R, 2, 1> gradient(const Frame<R>& f, const R& turn) {
    Eigen::Matrix<R, 2, 1> g;
    for (int i = 0; i < 2; ++i) {
      const R across = f.n[i] * f.angle;
      const R along = !f.at_end ? R(f.u[i] * f.log_ratio) : f.way[i] == 0 ? R(0) : R(R(f.way[i]) * f.log_ratio);
      g[i] = turn * (along - across);
    }
    return g;
  }

  template <Scalar R>
  static Eigen::Matrix<R, 2, 2> hessian(const Frame<R>& f, const R& turn) {
    if (f.at_end) return Eigen::Matrix<R, 2, 2>::Constant(std::numeric_limits<R>::quiet_NaN());
    // 1/z1 - 1/z0 = -length/(z0 z1), whose parts are each a sum without cancellation beyond its modulus.
    const R slope = turn * f.length / (f.far_r() * f.far_r());
    const Complex<R> far{f.far_s(), -f.h}, product = far * f.near;
    const R scale = slope / f.near_mantissa;
    const R q = shifted<R>(-scale * product.re, -f.near_exponent), p = shifted<R>(scale * product.im, -f.near_exponent);
    return q * (f.n * f.n.transpose() - f.u * f.u.transpose()) + p * (f.u * f.n.transpose() + f.n * f.u.transpose());
  }
};

}  // namespace cageproof::closed_form::segment
