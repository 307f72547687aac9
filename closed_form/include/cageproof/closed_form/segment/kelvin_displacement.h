// SPDX-License-Identifier: MIT
// Kelvin's displacements of a segment, the normal part of Somigliana coordinates of polygons.
#pragma once

#include "cageproof/closed_form/arithmetic/kelvin_shares.h"
#include "cageproof/closed_form/segment/engine/kernel.h"
#include "cageproof/closed_form/segment/engine/logarithms.h"
#include "cageproof/closed_form/segment/engine/spin.h"

namespace cageproof::closed_form::segment {

/// K_s = int -(a - b) ln r I + b x x'/r^2 with a = 1/(2 pi mu), b = a/(4 (1 - nu)), row by row ([C23] Eq 3, 8 in the
/// plane): a length times the logarithm of one, over a modulus. Parameters mu > 0 and nu < 1/2, with the limits 1/2 and
/// +-infinity. With L = int ln r, F = int 1/z = log(z1/z0), and x x'/r^2 = (I + spin(z/conj(z)))/2, where z - conj(z) =
/// -2 i h all along the segment,
///   K = (b length/2 - (a - b) L) I + (b/2) spin(conj G),  G = int conj(z)/z = length + 2 i h F.
/// For a step v of the point, as a complex number (v_n its part along the normal), F changes by v int 1/z^2, G by
/// 2 i (v_n F + h v int 1/z^2) and L by -Re(v F). Finite everywhere; at an end the gradient is infinite where the
/// logarithm of the distance enters it, NaN elsewhere, as is the Hessian.
struct KelvinDisplacement {
  static constexpr int components = 4, parameter_count = 2;
  static constexpr bool has_signs_at_ends = true;
  static LogarithmicPart logarithmic_part(std::span<const double> parameters) {
    const double bulk = KelvinShares<double>(parameters[1]).bulk;
    return {(1 - bulk / 2) / (2 * pi<double>()) / parameters[0], 0};
  }

  /// Value and derivatives up to order O, in the caller's units.
  template <int O, class F, class R = typename F::Number>
  static Jet<R, 4, 2> at(const F& f, const Given<R>& given) {
    Jet<R, 4, 2> jet;
    const R bulk = KelvinShares<R>(given.parameters[1]).bulk;
    const Shares<R> k{given.parameters[0], 1 / (2 * pi<R>()), 1 - bulk / 2, bulk / 4};
    const Complex<R> lifted = f.at_end ? Complex<R>{R(0), R(0)} : Complex<R>{f.h * f.log_ratio, f.h * f.angle};
    set<R>(k, -(integral_of_logarithm(f) + f.length * unit_logarithm(f)), f.length,
           Spin<R>(f, conjugate(Complex<R>{f.length - 2 * lifted.im, 2 * lifted.re})), f.exponent, jet.value);
    if constexpr (O >= 1) {
      if (f.at_end) {
        set_at_end<O>(f, k, given.finite_part, jet);
        return jet;
      }
      set_derivatives<O>(f, k, jet);
    }
    return jet;
  }

 private:
  // a = turn/mu; of K/a (a - b)/a stands before the logarithm, b/(2 a) before the rest.
  template <Scalar R>
  struct Shares {
    R mu, turn, round, bent;
  };

  // a (round potential I + bent (size I + spin)), in units of 2^exponent.
  template <Scalar R>
  static void set(const Shares<R>& k, const R& potential, const R& size, const Spin<R>& spin, int exponent,
                  std::array<R, 4>& matrix) {
    const R diagonal = k.round * potential + k.bent * size;
    for (int row = 0; row < 2; ++row)
      for (int column = 0; column < 2; ++column)
        matrix[2 * row + column] =
            shifted<R>(R(k.turn * ((row == column ? diagonal : R(0)) + k.bent * spin(row, column))), exponent) / k.mu;
  }

  template <int O, Scalar R>
  static void set_derivatives(const Frame<R>& f, const Shares<R>& k, Jet<R, 4, 2>& jet) {
    // Products, which cancel nothing. The far end goes first, so that no product is larger than the result.
    const Complex<R> to_far = f.scaled_inverse(1 - f.near_end), to_near = f.scaled_inverse(f.near_end);
    const Complex<R> first{f.log_ratio, f.angle}, square = (f.length * to_far) * to_near;  // int 1/z^2
    const Complex<R> cube = square * (to_far + to_near);                                   // int 2/z^3
    std::array<R, 4> matrix;
    for (int i = 0; i < 2; ++i) {
      const Complex<R> v{f.u[i], f.n[i]};
      const Complex<R> bend = R(2) * turned(f.n[i] * first + (f.h * v) * square);
      set<R>(k, (v * first).re, R(0), Spin<R>(f, conjugate(bend)), 0, matrix);
      for (int c = 0; c < 4; ++c) jet.gradient[c][i] = matrix[c];
      for (int j = 0; O >= 2 && j < 2; ++j) {
        const Complex<R> w{f.u[j], f.n[j]};
        const Complex<R> curve = R(2) * turned((f.n[i] * w + f.n[j] * v) * square + (f.h * (v * w)) * cube);
        set<R>(k, (v * w * square).re, R(0), Spin<R>(f, conjugate(curve)), -f.exponent, matrix);
        for (int c = 0; c < 4; ++c) jet.hessian[c](i, j) = matrix[c];
      }
    }
  }

  // Below this the logarithm's factor is called zero: a few roundings of 53 bits, 100 or 200 digits.
  template <Scalar R>
  static constexpr double kNoise = !is_wide<R>                              ? 0x1p-48
                                   : std::numeric_limits<R>::digits10 < 150 ? 1e-90
                                                                            : 1e-190;

  // Where the logarithm of the distance enters the gradient there is its sign: (a - b) Re(v F) I - 2 (b/2) v_n Re F
  // (u n' + n u') grows like Re F, which is infinite.
  template <int O, Scalar R>
  static void set_at_end(const Frame<R>& f, const Shares<R>& k, bool finite_part, Jet<R, 4, 2>& jet) {
    const R nan = std::numeric_limits<R>::quiet_NaN(), infinity = std::numeric_limits<R>::infinity();
    const R sign(f.near_end == 0 ? 1 : -1), noise = R(kNoise<R>);
    const Spin<R> spin(f, {R(0), R(1)});
    for (int row = 0; row < 2; ++row)
      for (int column = 0; column < 2; ++column)
        for (int i = 0; i < 2; ++i) {
          const R factor =
              sign * ((row == column ? R(k.round * f.u[i]) : R(0)) - 2 * k.bent * f.n[i] * spin(row, column));
          const bool infinite = !finite_part && (factor > noise || -factor > noise);
          jet.gradient[2 * row + column][i] = !infinite ? nan : factor > 0 ? infinity : R(-infinity);
        }
    if constexpr (O >= 2)
      for (auto& h : jet.hessian) h.fill(nan);
  }
};

}  // namespace cageproof::closed_form::segment
