// SPDX-License-Identifier: MIT
// The single layer of a segment's hat functions in the plane.
#pragma once

#include "cageproof/closed_form/segment/engine/kernel.h"
#include "cageproof/closed_form/segment/engine/hat_integrals.h"
#include "cageproof/closed_form/segment/engine/logarithms.h"

namespace cageproof::closed_form::segment {

/// psi_s^k = int -Gamma_k ln r/(2 pi), [T24] Eq 43 with the plane's G1 ([W12] Section 3): a length times the logarithm
/// of one; its gradient has no unit, its Hessian is 1/length. On the segment: the limit
/// from inside. At its ends values have limits; the gradient of the end's own hat function is infinite along the
/// segment, the other's has a limit; Hessians have none: NaN.
struct AffineSingleLayer {
  static constexpr int components = 2;
  static LogarithmicPart logarithmic_part(std::span<const double>) { return {1 / (2 * pi<double>()), 0}; }

  /// Value and derivatives up to order O, in the caller's units.
  template <int O, class F, class R = typename F::Number>
  static Jet<R, 2, 2> at(const F& f) {
    Jet<R, 2, 2> jet;
    const R turn = 1 / (2 * pi<R>());
    const std::array<R, 2> logarithms = hat_logarithms(f);
    for (int k = 0; k < 2; ++k)
      jet.value[k] = shifted<R>(-turn * (logarithms[k] + f.length / 2 * unit_logarithm(f)), f.exponent);
    if constexpr (O >= 1) {
      const HatIntegrals<O - 1, R> hats = hat_integrals<O - 1>(f);
      for (int k = 0; k < 2; ++k) {
        jet.gradient[k] = gradient(f, hats.inverse[k], turn);
        if constexpr (O >= 2) jet.hessian[k] = hessian(f, hats.square[k], turn);
      }
    }
    return jet;
  }

 private:
  template <Scalar R>
  static Eigen::Matrix<R, 2, 1> gradient(const Frame<R>& f, const Complex<R>& inverse, const R& turn) {
    using std::abs;
    Eigen::Matrix<R, 2, 1> g;
    const bool infinite = abs(inverse.re) == R(std::numeric_limits<double>::infinity());
    for (int i = 0; i < 2; ++i) {
      const R across = f.n[i] * inverse.im;
      const R along = !infinite ? R(f.u[i] * inverse.re) : f.way[i] == 0 ? R(0) : R(R(f.way[i]) * inverse.re);
      g[i] = turn * (along - across);
    }
    return g;
  }

  template <Scalar R>
  static Eigen::Matrix<R, 2, 2> hessian(const Frame<R>& f, const Complex<R>& square, const R& turn) {
    if (f.at_end) return Eigen::Matrix<R, 2, 2>::Constant(std::numeric_limits<R>::quiet_NaN());
    Eigen::Matrix<R, 2, 2> hessian = turn * square.re * (f.u * f.u.transpose() - f.n * f.n.transpose()) -
                                     turn * square.im * (f.u * f.n.transpose() + f.n * f.u.transpose());
    for (int i = 0; i < 2; ++i)
      for (int j = 0; j < 2; ++j) hessian(i, j) = shifted<R>(hessian(i, j), -f.exponent);
    return hessian;
  }
};

}  // namespace cageproof::closed_form::segment
