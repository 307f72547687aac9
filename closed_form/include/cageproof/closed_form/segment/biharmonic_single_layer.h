// SPDX-License-Identifier: MIT
// The biharmonic potential of a segment with unit charge in the plane.
#pragma once

#include "cageproof/closed_form/arithmetic/jet.h"
#include "cageproof/closed_form/segment/engine/closed_form.h"
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

  /// Value and derivatives up to order O, in the caller's units.
  template <int O, Scalar R>
  static Jet<R, 1, 2> at(const Frame<R>& f) {
    Jet<R, 1, 2> jet;
    const R factor = 1 / (8 * pi<R>()), unit = unit_logarithm(f);
    const R &s0 = f.s[0], &s1 = f.s[1], &length = f.length, &h = f.h, square = h * h;
    const R squares = s0 * s0 + s0 * s1 + s1 * s1;
    R value, along, across;
    if (f.is_for_sums()) {
      const FarSquareLogarithm<R> far(f);
      value = far.value;
      along = far.along;
      across = far.across;
    } else {
      const std::array<R, 2> cubic{(s0 * s0 / 3 + square) * s0, (s1 * s1 / 3 + square) * s1};
      value = ends(f, cubic) - length * (squares / 9 + 2 * square / 3) + 2 * square * h * f.angle / 3;
      const R first = f.r[0] * f.r[0], last = f.r[1] * f.r[1];
      along = f.are_alike() ? R(((first + last) * f.log_ratio + length * f.sum * (f.log_r[0] + f.log_r[1] - 2)) / 2)
                            : ends(f, {first, last});
      across = -h * (2 * integral_of_logarithm(f) - length);
    }
    jet.value[0] = shifted<R>(-factor * (value + unit * length * (squares / 3 + square)), 3 * f.exponent);
    if constexpr (O >= 1) {
      const R of_u = factor * (along + unit * length * f.sum), of_n = factor * (across - 2 * unit * length * h);
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

 private:
  // [factor (ln r - 1)] between the ends; a factor that vanishes at an end takes its logarithm with it.
  template <Scalar R>
  static R ends(const Frame<R>& f, const std::array<R, 2>& factor) {
    std::array<R, 2> at;
    for (int i = 0; i < 2; ++i) at[i] = f.at_end && i == f.near_end ? R(0) : R(factor[i] * (f.log_r[i] - 1));
    return at[1] - at[0];
  }
};

}  // namespace cageproof::closed_form::segment
