// SPDX-License-Identifier: MIT
// Kelvin's tractions weighted with a segment's hat functions, the vertex part of Somigliana coordinates of polygons.
#pragma once

#include "cageproof/closed_form/arithmetic/kelvin_shares.h"
#include "cageproof/closed_form/segment/engine/kernel.h"
#include "cageproof/closed_form/segment/engine/hat_integrals.h"
#include "cageproof/closed_form/segment/engine/spin.h"

namespace cageproof::closed_form::segment {

/// T_s^k = int Gamma_k mu ((a - 2b)(x.n I + n x' - x n')/r^2 + 4b x.n x x'/r^4), row by row ([C23] Eq 4, 8 in the
/// plane, a and b as in K_s): unitless, independent of mu. With F_k = int Gamma_k/z, S_k = int Gamma_k/z^2 and
/// J = n u' - u n' the quarter turn, (x.n I + n x' - x n')/r^2 is the matrix of the product with i/z, so that
///   2 pi T = -Im F_k I + ((a - 2b)/a) Re F_k J - (2b/a) h spin(conj S_k).
/// On the segment: the limit from inside. At an end, the logarithm of the distance makes off-diagonal entries of the
/// end's hat function infinite, unless nu = 1/2; other entries are limits along the normal. Derivatives have no limit
/// there: NaN. In sums over a polygon the logarithms cancel.
struct KelvinTraction {
  static constexpr int components = 8, parameter_count = 2;
  static constexpr bool has_signs_at_ends = true;

  /// Value and derivatives up to order O, in the caller's units.
  template <int O, class F, class R = typename F::Number>
  static Jet<R, 8, 2> at(const F& f, const Given<R>& given) {
    Jet<R, 8, 2> jet;
    const KelvinShares<R> shares(given.parameters[1]);
    const R turn = 1 / (2 * pi<R>());
    const Parts<R> part{turn, turn * shares.shear, turn * shares.bulk};
    const HatIntegrals<1, R> hats = hat_integrals<1>(f);
    for (int k = 0; k < 2; ++k) {
      std::array<R, 4> matrix;
      if (f.at_end) set_at_end(f, k, hats.inverse[k], given.finite_part, part, matrix);
      else set(part, hats.inverse[k], Spin<R>(f, f.h * conjugate(hats.square[k])), 0, matrix);
      for (int c = 0; c < 4; ++c) jet.value[4 * k + c] = matrix[c];
      if constexpr (O >= 1) set_derivatives<O>(f, k, hats.square[k], part, jet);
    }
    return jet;
  }

 private:
  // The factors of the identity, the quarter turn and the spin.
  template <Scalar R>
  struct Parts {
    R round, shear, bulk;
  };

  template <Scalar R>
  static void set(const Parts<R>& part, const Complex<R>& inverse, const Spin<R>& spin, int exponent,
                  std::array<R, 4>& matrix) {
    // J = ((0, 1), (-1, 0)), whatever the segment's direction.
    const R diagonal = -part.round * inverse.im, pull = part.shear * inverse.re;
    matrix = {diagonal - part.bulk * spin.diagonal, pull - part.bulk * spin.mixed, -pull - part.bulk * spin.mixed,
              diagonal + part.bulk * spin.diagonal};
    for (R& x : matrix) x = shifted<R>(x, exponent);
  }

  // Along the normal h/z goes to i at the nearer end, and h/z^2 with it.
  template <Scalar R>
  static void set_at_end(const Frame<R>& f, int k, const Complex<R>& inverse, bool finite_part, const Parts<R>& part,
                         std::array<R, 4>& matrix) {
    if (k != f.near_end) return set(part, inverse, Spin<R>(f, {R(0), R(0)}), 0, matrix);
    const R sign(f.near_end == 0 ? 1 : -1);
    const Complex<R> finite{R(0), inverse.im};
    set(part, finite, Spin<R>(f, {R(0), -sign}), 0, matrix);
    if (finite_part || part.shear == R(0)) return;
    matrix[1] = sign * std::numeric_limits<R>::infinity();
    matrix[2] = -matrix[1];
  }

  template <int O, Scalar R>
  static void set_derivatives(const Frame<R>& f, int k, const Complex<R>& square, const Parts<R>& part,
                              Jet<R, 8, 2>& jet) {
    if (f.at_end) {
      for (int c = 0; c < 4; ++c) {
        jet.gradient[4 * k + c].fill(std::numeric_limits<R>::quiet_NaN());
        if constexpr (O >= 2) jet.hessian[4 * k + c].fill(std::numeric_limits<R>::quiet_NaN());
      }
      return;
    }
    // int 2 Gamma_k/z^3 = length/(z_k^2 z_l) and int 6 Gamma_k/z^4: products, which cancel nothing. The far end goes
    // first, so that no product is larger than the result.
    const Complex<R> to_far = f.scaled_inverse(1 - f.near_end), to_near = f.scaled_inverse(f.near_end);
    const Complex<R>&own = k == f.near_end ? to_near : to_far, &other = k == f.near_end ? to_far : to_near;
    const Complex<R> cube = ((f.length * to_far) * own) * to_near, fourth = cube * (R(2) * own + other);
    std::array<R, 4> matrix;
    for (int i = 0; i < 2; ++i) {
      const Complex<R> v{f.u[i], f.n[i]};
      const Complex<R> bend = f.n[i] * square + (f.h * v) * cube;
      set(part, v * square, Spin<R>(f, conjugate(bend)), -f.exponent, matrix);
      for (int c = 0; c < 4; ++c) jet.gradient[4 * k + c][i] = matrix[c];
      for (int j = 0; O >= 2 && j < 2; ++j) {
        const Complex<R> w{f.u[j], f.n[j]};
        const Complex<R> curve = (f.n[i] * w + f.n[j] * v) * cube + (f.h * (v * w)) * fourth;
        set(part, v * w * cube, Spin<R>(f, conjugate(curve)), -2 * f.exponent, matrix);
        for (int c = 0; c < 4; ++c) jet.hessian[4 * k + c](i, j) = matrix[c];
      }
    }
  }
};

}  // namespace cageproof::closed_form::segment
