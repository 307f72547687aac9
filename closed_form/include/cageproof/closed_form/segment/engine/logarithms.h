// SPDX-License-Identifier: MIT
// Integrals of the distance's logarithm along a segment, in units of the frame: with the unit's own logarithm,
// unit_logarithm(), times what stands before the logarithm, they are those of the caller.
#pragma once

#include "cageproof/closed_form/segment/engine/far_sums.h"

namespace cageproof::closed_form::segment {

/// The natural logarithm of the frame's unit of length.
template <Scalar R>
R unit_logarithm(const Frame<R>& f) {
  if constexpr (is_multiprecision<R>) return R(0);
  else return R(f.exponent * ln_two<R>());
}

/// int ln r = s1 ln r1 - s0 ln r0 - length + h alpha.
template <Scalar R>
R integral_of_logarithm(const Frame<R>& f) {
  const std::array<R, 2>&s = f.s, &log_r = f.log_r;
  R ends;
  if (f.is_far()) {
    // Both terms are much larger than their difference.
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
/// or their mirror images, so that of the nearer end's logarithm no more is left than what is small there.
template <Scalar R>
std::array<R, 2> hat_logarithms(const Frame<R>& f) {
  if (f.is_for_sums()) return FarLogarithms<R>(f).hats;
  const R &s0 = f.s[0], &s1 = f.s[1], &length = f.length, square = f.h * f.h;
  const R far = length * f.log_r[1 - f.near_end] / 2, across = f.h * f.angle;
  const R of_first = f.near_end == 0 ? R(s0 * (s1 + length) - square) : R(s1 * s1 - square);
  const R of_last = f.near_end == 0 ? R(square - s0 * s0) : R((length - s0) * s1 + square);
  const auto part = [&](const R& factor) { return f.at_end ? R(0) : R(factor * f.log_ratio / 2); };
  return {far + (part(of_first) + s1 * across) / length - (2 * s1 + length) / 4,
          far + (part(of_last) - s0 * across) / length + (2 * s0 - length) / 4};
}

}  // namespace cageproof::closed_form::segment
