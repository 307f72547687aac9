// SPDX-License-Identifier: MIT
// The biharmonic potential of a segment with unit charge in the plane.
#pragma once

#include "cageproof/closed_form/arithmetic/jet.h"
#include "cageproof/closed_form/segment/engine/kernel.h"
#include "cageproof/closed_form/segment/engine/logarithms.h"

namespace cageproof::closed_form::segment {

/// psibar_s = int -r^2 (ln r - 1)/(8 pi) ([W12] Section 4.1, sign of G2 after the errata): a volume times the logarithm
/// of a length; its Laplacian is psi_s. With lambda = ln(r1/r0), alpha the angle under which the segment is seen and
/// x = s u - h n:
///   int r^2 (ln r - 1) = [(s^3/3 + h^2 s)(ln r - 1) - s^3/9 - 2 h^2 s/3] + 2 h^3 alpha/3 between the ends,
///   int x (2 ln r - 1) = [r^2 (ln r - 1)] u - h (2 int ln r - length) n,
///   int x x'/r^2 = (length - h alpha) u u' + h alpha n n' - h lambda (u n' + n u').
/// All have limits on the segment and at its ends, and are continuous.
struct BiharmonicSingleLayer {
  static constexpr int components = 1;
  static LogarithmicPart logarithmic_part(std::span<const double>) { return {1 / (8 * pi<double>()), 2}; }

  /// Value and derivatives up to order O, in the caller's units.
  template <int O, class F, class R = typename F::Number>
  static Jet<R, 1, 2> at(const F& f) {
    Jet<R, 1, 2> jet;
    const R factor = 1 / (8 * pi<R>()), unit = unit_logarithm(f);
    const R &s0 = f.s[0], &s1 = f.s[1], &length = f.length, &h = f.h, square = h * h;
    const R squares = s0 * s0 + s0 * s1 + s1 * s1;
    const SquareLogarithm<R> of = square_logarithm(f);
    jet.value[0] = shifted<R>(-factor * (of.value + unit * length * (squares / 3 + square)), 3 * f.exponent);
    if constexpr (O >= 1) {
      const R of_u = factor * (of.along + unit * length * f.sum), of_n = factor * (of.across - 2 * unit * length * h);
      for (int i = 0; i < 2; ++i) jet.gradient[0][i] = shifted<R>(of_u * f.u[i] + of_n * f.n[i], 2 * f.exponent);
    }
    if constexpr (O >= 2) {
      const R lift = h * f.angle, mixed = f.at_end ? R(0) : R(h * f.log_ratio);
      const R round = 2 * (integral_of_logarithm(f) + unit * length) - length;
      const R uu = round + 2 * (length - lift), nn = round + 2 * lift, un = -2 * mixed;
      for (int i = 0; i < 2; ++i)
        for (int j = 0; j < 2; ++j)
          jet.hessian[0](i, j) = shifted<R>(
              -factor * (uu * f.u[i] * f.u[j] + nn * f.n[i] * f.n[j] + un * (f.u[i] * f.n[j] + f.n[i] * f.u[j])),
              f.exponent);
    }
    return jet;
  }
};

}  // namespace cageproof::closed_form::segment
