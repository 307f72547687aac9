// SPDX-License-Identifier: MIT
// The frame of a segment with bounds of its own rounding.
#pragma once

#include "cageproof/closed_form/segment/engine/exact_frame.h"

namespace cageproof::closed_form::segment {

/// Whether products of a few of the frame's numbers may leave double's range, or have no bound: at an end some are
/// infinite, and a direction off the line may have become zero. All else is far from both ends of the range: powers up
/// to the eleventh of a distance, those of polyharmonic layers, in units of the frame and of the caller, times an angle
/// as small as 2^-200.
inline bool leaves_range(const Segment<double>& s, const Vec3<double>& eta, const Frame<double>& f) {
  constexpr int kUnit = 70, kWithin = 100;
  const auto extreme = [](double x, int bits) { return std::abs(x) < std::ldexp(1., -bits); };
  return f.at_end || std::abs(f.exponent) > kUnit || f.near_exponent - f.exponent < -kWithin ||
         extreme(f.length, kWithin) || (extreme(f.near.im, 2 * kWithin) && side_of_line(s, eta) != 0);
}

/// Coordinates' differences are exact double-doubles. A component or a product of them is rounded once; a hypotenuse is
/// good to an ulp. Sums of products are formed in double-double, to 2^-98 of the factors' lengths; the sine, which is
/// taken from exact differences where it is small, to 2^-52 of itself.
template <Scalar R>
template <std::same_as<double> D>
Frame<R>::Frame(const Frame<D>& plain) requires is_tracked<R> : way(plain.way),
                                                                exponent(plain.exponent),
                                                                near_end(plain.near_end),
                                                                at_end(plain.at_end),
                                                                near_exponent(plain.near_exponent) {
  constexpr double kOfDistance = 3, kOfDirection = 5, kOfArc = 6, kOfSine = 11;
  constexpr double kOfSums = 0x1p-98 / 0x1p-53;
  const auto good_to = [](double x, double roundings, double beside = 0) { return R::rounded(x, beside, roundings); };
  length = good_to(plain.length, kOfDistance);
  for (int i = 0; i < 2; ++i) {
    u[i] = good_to(plain.u[i], kOfDirection);
    r[i] = good_to(plain.r[i], kOfDistance);
    s[i] = good_to(plain.s[i], kOfArc, kOfSums * plain.r[i]);
    log_r[i] = log(r[i]);
  }
  n = {u[1], -u[0]};
  sum = good_to(plain.sum, kOfArc, kOfSums * (plain.r[0] + plain.r[1]));
  near_mantissa = good_to(plain.near_mantissa, kOfDistance);
  near = {good_to(plain.near.re, kOfArc + kOfDistance, kOfSums), good_to(plain.near.im, kOfSine)};
  h = -near.im * r[near_end];
  set_angle_and_ratio();
}

}  // namespace cageproof::closed_form::segment
