// SPDX-License-Identifier: MIT
// Integrals of the distance's logarithm along a segment, in units of the frame. The caller's need unit_logarithm()
// times the logarithm's factor in addition.
#pragma once

#include "cageproof/closed_form/segment/engine/frame.h"

namespace cageproof::closed_form::segment {

/// The natural logarithm of the frame's unit of length.
template <Scalar R>
R unit_logarithm(const Frame<R>& f) {
  if constexpr (is_wide<R>) return R(0);
  else return R(f.exponent) * ln_two<R>();
}

/// int ln r = s1 ln r1 - s0 ln r0 - length + h alpha.
template <Scalar R>
R integral_of_logarithm(const Frame<R>& f) {
  const std::array<R, 2>&s = f.s, &log_r = f.log_r;
  R ends;
  if (f.is_far()) {
    // The two ends' terms are much larger than their difference, so the difference is written out.
    ends = (f.length * (log_r[0] + log_r[1]) + f.sum * f.log_ratio) / 2;
  } else {
    const R at_near = f.at_end ? R(0) : R(s[f.near_end] * log_r[f.near_end]),
            at_far = f.far_s() * log_r[1 - f.near_end];
    ends = f.near_end == 0 ? R(at_far - at_near) : R(at_near - at_far);
  }
  return ends - (f.length - f.h * f.angle);
}

/// int Gamma_k ln r. With lambda = ln(r1/r0) and alpha the angle under which the segment is seen:
///   int Gamma_0 ln r = length ln(r1)/2 + ((s0 (s1 + length) - h^2) lambda/2 + s1 h alpha)/length - (2 s1 + length)/4,
///   int Gamma_1 ln r = length ln(r1)/2 + ((h^2 - s0^2) lambda/2 - s0 h alpha)/length + (2 s0 - length)/4,
/// or their mirror images, so that the nearer end's logarithm has only small factors.
template <Scalar R>
std::array<R, 2> hat_logarithms(const Frame<R>& f) {
  const R &s0 = f.s[0], &s1 = f.s[1], &length = f.length, square = f.h * f.h;
  const R far = length * f.log_r[1 - f.near_end] / 2, across = f.h * f.angle;
  const R of_first = f.near_end == 0 ? R(s0 * (s1 + length) - square) : R(s1 * s1 - square);
  const R of_last = f.near_end == 0 ? R(square - s0 * s0) : R((length - s0) * s1 + square);
  const auto part = [&](const R& factor) { return f.at_end ? R(0) : R(factor * f.log_ratio / 2); };
  return {far + (part(of_first) + s1 * across) / length - (2 * s1 + length) / 4,
          far + (part(of_last) - s0 * across) / length + (2 * s0 - length) / 4};
}

/// Integrals of r^2 (ln r - 1) and of its derivatives, in units of the frame.
template <Scalar R>
struct SquareLogarithm {
  R value{};            ///< int r^2 (ln r - 1)
  R along{}, across{};  ///< int x (2 ln r - 1) along the segment and its normal
};

/// The integrals from terms at the ends: int r^2 (ln r - 1) = [(s^3/3 + h^2 s)(ln r - 1) - s^3/9 - 2 h^2 s/3] + 2 h^3
/// alpha/3, int x (2 ln r - 1) = [r^2 (ln r - 1)] u - h (2 int ln r - length) n.
template <Scalar R>
SquareLogarithm<R> square_logarithm(const Frame<R>& f) {
  // [factor (ln r - 1)] between the ends; a factor that vanishes at an end takes its logarithm with it.
  const auto between_ends = [&f](const std::array<R, 2>& factor) {
    std::array<R, 2> at;
    for (int i = 0; i < 2; ++i) at[i] = f.at_end && i == f.near_end ? R(0) : R(factor[i] * (f.log_r[i] - 1));
    return R(at[1] - at[0]);
  };
  const R &s0 = f.s[0], &s1 = f.s[1], &length = f.length, &h = f.h, square = h * h;
  const R squares = s0 * s0 + s0 * s1 + s1 * s1;
  const std::array<R, 2> cubic{(s0 * s0 / 3 + square) * s0, (s1 * s1 / 3 + square) * s1};
  const R first = f.r[0] * f.r[0], last = f.r[1] * f.r[1];
  SquareLogarithm<R> of;
  of.value = between_ends(cubic) - length * (squares / 9 + 2 * square / 3) + 2 * square * h * f.angle / 3;
  of.along = f.are_alike() ? R(((first + last) * f.log_ratio + length * f.sum * (f.log_r[0] + f.log_r[1] - 2)) / 2)
                           : between_ends({first, last});
  of.across = -h * (2 * integral_of_logarithm(f) - length);
  return of;
}

}  // namespace cageproof::closed_form::segment
