// SPDX-License-Identifier: MIT
// Mean value weights of a segment of the plane.
#pragma once

#include "cageproof/closed_form/arithmetic/jet.h"
#include "cageproof/closed_form/segment/engine/kernel.h"

namespace cageproof::closed_form::segment {

/// w_s^k = int Gamma_k x.n/r^3 ([T18] Eq 11 in the plane): 1/length, positive inside; normalised over a polygon they
/// are mean value coordinates. With alpha the angle under which the segment is seen (positive outside): w^k =
/// -tan(alpha/2)/ r_k. On the segment they diverge: infinite within and at the end that is the point, NaN for the other
/// end's weight there, whose limit depends on the direction; derivatives are NaN.
struct MeanValue {
  static constexpr int components = 2;
  /// Next to the segment's line double has no digits of the square of the height.
  static constexpr bool diverges_on_segment = true;

  /// Value and derivatives up to order O, in the caller's units.
  template <int O, class F, class R = typename F::Number>
  static Jet<R, 2, 2> at(const F& f) {
    const bool within = f.near.im == R(0) && f.s[0] < R(0) && R(0) < f.s[1];
    if (f.at_end || within) return diverging<O>(f);
    const R tangent = half_tangent(f);
    Jet<R, 2, 2> jet;
    for (int k = 0; k < 2; ++k) {
      // In units of the frame, so that powers of the unit leave no range.
      const R inverse = k == f.near_end ? shifted<R>(1 / f.near_mantissa, f.exponent - f.near_exponent) : 1 / f.r[k];
      jet.value[k] = shifted<R>(-tangent * inverse, -f.exponent);
      if constexpr (O >= 1) set_derivatives<O>(f, k, tangent, inverse, jet);
    }
    return jet;
  }

 private:
  // tan(alpha/2) from the sine and cosine of alpha, whichever of its two forms does not cancel.
  template <Scalar R>
  static R half_tangent(const Frame<R>& f) {
    // Over the product of the distances, the near one's direction keeps its digits at any distance.
    const R sine = f.length * -f.near.im / f.far_r(), cosine = (f.far_s() * f.near.re - f.h * f.near.im) / f.far_r();
    return cosine >= R(0) ? R(sine / (1 + cosine)) : R((1 - cosine) / sine);
  }

  template <int O, Scalar R>
  static void set_derivatives(const Frame<R>& f, int k, const R& tangent, const R& inverse, Jet<R, 2, 2>& jet) {
    using Vec = Eigen::Matrix<R, 2, 1>;
    const Complex<R> to_far = f.scaled_inverse(1 - f.near_end), to_near = f.scaled_inverse(f.near_end),
                     own = f.scaled_inverse(k);
    const Complex<R> square = (f.length * to_far) * to_near;  // int 1/z^2
    const R slope = (1 + tangent * tangent) / 2;              // of the tangent by alpha
    const Vec of_angle = square.im * f.u + square.re * f.n, away = own.re * f.u - own.im * f.n;
    const Vec gradient = -inverse * (slope * of_angle + tangent * away);
    for (int i = 0; i < 2; ++i) jet.gradient[k][i] = shifted<R>(gradient[i], -2 * f.exponent);
    if constexpr (O >= 2) {
      const Complex<R> cube = square * (to_far + to_near);  // int 2/z^3
      const Eigen::Matrix<R, 2, 2> bend = cube.im * (f.u * f.u.transpose() - f.n * f.n.transpose()) +
                                          cube.re * (f.u * f.n.transpose() + f.n * f.u.transpose()) +
                                          tangent * (of_angle * of_angle.transpose());
      const Eigen::Matrix<R, 2, 2> mixed = of_angle * away.transpose() + away * of_angle.transpose();
      const Eigen::Matrix<R, 2, 2> of_distance =
          3 * away * away.transpose() - away.dot(away) * Eigen::Matrix<R, 2, 2>::Identity();
      const Eigen::Matrix<R, 2, 2> hessian = -inverse * (slope * (bend + mixed) + tangent * of_distance);
      for (int i = 0; i < 2; ++i)
        for (int j = 0; j < 2; ++j) jet.hessian[k](i, j) = shifted<R>(hessian(i, j), -3 * f.exponent);
    }
  }

  template <int O, Scalar R>
  static Jet<R, 2, 2> diverging(const Frame<R>& f) {
    const R nan = std::numeric_limits<R>::quiet_NaN();
    Jet<R, 2, 2> jet;
    for (int k = 0; k < 2; ++k) {
      jet.value[k] = f.at_end && k != f.near_end ? nan : std::numeric_limits<R>::infinity();
      if constexpr (O >= 1) jet.gradient[k].fill(nan);
      if constexpr (O >= 2) jet.hessian[k].fill(nan);
    }
    return jet;
  }
};

}  // namespace cageproof::closed_form::segment
