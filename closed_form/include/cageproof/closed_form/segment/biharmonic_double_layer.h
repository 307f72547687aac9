// SPDX-License-Identifier: MIT
// The biharmonic double layer of a segment's hat functions in the plane.
#pragma once

#include "cageproof/closed_form/arithmetic/jet.h"
#include "cageproof/closed_form/segment/engine/kernel.h"
#include "cageproof/closed_form/segment/engine/hat_integrals.h"
#include "cageproof/closed_form/segment/engine/logarithms.h"

namespace cageproof::closed_form::segment {

/// phibar_s^k = int Gamma_k x.n (2 ln r - 1)/(8 pi) ([W12] Section 4.1 after the errata): an area times the logarithm
/// of a length; its Laplacian is phi_s^k. x.n = -h is the same all along, so that with F_k = int Gamma_k/z, whose parts
/// are those of int Gamma_k x/r^2, and S_k = int Gamma_k/z^2
///   8 pi phibar = -h q_k,  q_k = 2 int Gamma_k ln r - length/2,
///   8 pi grad phibar = -q_k n + 2 h (Re F_k u - Im F_k n),
///   8 pi Hess phibar = 2 h Re S_k (u u' - n n') + (2 Re F_k - 2 h Im S_k)(u n' + n u') - 4 Im F_k n n'.
/// Zero on the segment's line, where the Hessian is the limit from inside. At the ends that of the end's own hat
/// function is infinite where a logarithm enters, with its sign, and has no limit elsewhere: NaN.
struct BiharmonicDoubleLayer {
  static constexpr int components = 2;
  static constexpr bool has_signs_at_ends = true;
  static LogarithmicPart logarithmic_part(std::span<const double>) { return {1 / (4 * pi<double>()), 1, true}; }

  /// Value and derivatives up to order O, in the caller's units.
  template <int O, class F, class R = typename F::Number>
  static Jet<R, 2, 2> at(const F& f) {
    Jet<R, 2, 2> jet;
    const R factor = 1 / (8 * pi<R>());
    std::array<R, 2> q = hat_logarithms(f);
    for (int k = 0; k < 2; ++k) {
      q[k] = 2 * q[k] + f.length * (unit_logarithm(f) - R(1) / 2);
      jet.value[k] = shifted<R>(-factor * f.h * q[k], 2 * f.exponent);
    }
    if constexpr (O >= 1) {
      const HatIntegrals<O - 1, R> hats = hat_integrals<O - 1>(f);
      for (int k = 0; k < 2; ++k) {
        const Complex<R>& inverse = hats.inverse[k];
        const R of_u = f.at_end ? R(0) : R(2 * f.h * inverse.re), of_n = f.at_end ? R(0) : R(2 * f.h * inverse.im);
        for (int i = 0; i < 2; ++i)
          jet.gradient[k][i] = shifted<R>(factor * (of_u * f.u[i] - (q[k] + of_n) * f.n[i]), f.exponent);
        if constexpr (O >= 2) jet.hessian[k] = f.at_end ? at_end(f, k, inverse, factor) : hessian(f, hats, k, factor);
      }
    }
    return jet;
  }

 private:
  template <Scalar R>
  static Eigen::Matrix<R, 2, 2> hessian(const Frame<R>& f, const HatIntegrals<1, R>& hats, int k, const R& factor) {
    const Complex<R>&first = hats.inverse[k], &square = hats.square[k];
    const R h = 2 * f.h;
    const R uu = h * square.re, un = 2 * first.re - h * square.im, nn = -4 * first.im - uu;
    return factor * (uu * f.u * f.u.transpose() + un * (f.u * f.n.transpose() + f.n * f.u.transpose()) +
                     nn * f.n * f.n.transpose());
  }

  // The other end's hat function vanishes here, and takes what has no limit with it.
  template <Scalar R>
  static Eigen::Matrix<R, 2, 2> at_end(const Frame<R>& f, int k, const Complex<R>& inverse, const R& factor) {
    Eigen::Matrix<R, 2, 2> hessian;
    for (int i = 0; i < 2; ++i)
      for (int j = 0; j < 2; ++j) {
        const R mixed = f.u[i] * f.n[j] + f.n[i] * f.u[j];
        // On the diagonal 2 u[0] u[1] and its negative, whose signs are known where they underflow.
        const int sign = i != j ? 0 : (i == 0 ? 1 : -1) * f.way[0] * f.way[1];
        const bool vanishes = i == j ? sign == 0 : mixed == R(0);
        if (k != f.near_end) hessian(i, j) = factor * 2 * inverse.re * mixed;
        else if (vanishes) hessian(i, j) = std::numeric_limits<R>::quiet_NaN();
        else hessian(i, j) = inverse.re * (i == j ? R(sign) : mixed);
      }
    return hessian;
  }
};

}  // namespace cageproof::closed_form::segment
