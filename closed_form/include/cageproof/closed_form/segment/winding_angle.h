// SPDX-License-Identifier: MIT
// The angle under which a point sees a segment of the plane.
#pragma once

#include "cageproof/closed_form/segment/engine/kernel.h"

namespace cageproof::closed_form::segment {

/// omega_s = int x.n/r^2, the plane's solid angle ([T24] Appendix A): positive inside, 2 pi over a whole polygon. It is
/// -Im F of F = log(z1/z0) = int 1/z, whose derivatives give those with respect to the point. On the segment: the limit
/// from inside, pi within, at its ends half of that; there derivatives have no limit: NaN. On the segment's line beyond
/// the ends the value is zero.
struct WindingAngle {
  static constexpr int components = 1;

  /// Value and derivatives up to order O, in the caller's units.
  template <int O, class F, class R = typename F::Number>
  static Jet<R, 1, 2> at(const F& f) {
    Jet<R, 1, 2> jet;
    jet.value[0] = -f.angle;
    if constexpr (O >= 1) {
      if (f.at_end) {
        jet.gradient[0].fill(std::numeric_limits<R>::quiet_NaN());
        jet.hessian[0].fill(O >= 2 ? std::numeric_limits<R>::quiet_NaN() : R(0));
        return jet;
      }
      // Products, which cancel nothing. The far end goes first, so that no product is larger than the result.
      const Complex<R> to_far = f.inverse(1 - f.near_end), to_near = f.inverse(f.near_end);
      const Complex<R> square = (shifted<R>(f.length, f.exponent) * to_far) * to_near;  // int 1/z^2
      jet.gradient[0] = -square.im * f.u - square.re * f.n;
      if constexpr (O >= 2) {
        // 1/z0 + 1/z1, whose terms cancel about the segment's middle, is (z0 + z1)/(z0 z1).
        const Complex<R> ends{shifted<R>(f.sum, f.exponent), shifted<R>(-2 * f.h, f.exponent)};
        const Complex<R> cube = square * ((ends * to_far) * to_near);  // int 2/z^3
        jet.hessian[0] = cube.im * (f.n * f.n.transpose() - f.u * f.u.transpose()) -
                         cube.re * (f.u * f.n.transpose() + f.n * f.u.transpose());
      }
    }
    return jet;
  }
};

}  // namespace cageproof::closed_form::segment
