// SPDX-License-Identifier: MIT
// Integrals of hat functions over powers of z, which all layers of hat functions in the plane are made of.
#pragma once

#include "cageproof/closed_form/segment/engine/frame.h"

namespace cageproof::closed_form::segment {

/// x/r^2 is the conjugate of 1/z, and (I - 2 x x'/r^2)/r^2 has the parts of 1/z^2. With log(z1/z0) = lambda + i alpha:
/// int Gamma_0/z = z1 log(z1/z0)/length - 1, int Gamma_1/z = 1 - z0 log(z1/z0)/length.
template <int O, Scalar R>
struct HatIntegrals {
  std::array<Complex<R>, 2> inverse;   ///< int Gamma_k/z: unitless; at an end that of its own hat function is infinite
  std::array<Complex<R>, 2> square{};  ///< O >= 1: int Gamma_k/z^2, in units of the frame; at an end not set

  HatIntegrals(const std::array<Complex<R>, 2>& of_inverse, const std::array<Complex<R>, 2>& of_square)
      : inverse(of_inverse), square(of_square) {}
  explicit HatIntegrals(const Frame<R>& f) {
    const std::array<R, 2> along{f.at_end && f.near_end == 0 ? R(0) : R(f.s[0] * f.log_ratio),
                                 f.at_end && f.near_end == 1 ? R(0) : R(f.s[1] * f.log_ratio)};
    const R lift = f.at_end ? R(0) : R(f.h * f.log_ratio), across = f.h * f.angle;
    inverse[0] = {(along[1] + across) / f.length - 1, (f.s[1] * f.angle - lift) / f.length};
    inverse[1] = {1 - (along[0] + across) / f.length, (lift - f.s[0] * f.angle) / f.length};
    if (O < 1 || f.at_end) return;
    const Complex<R> mean{f.log_ratio / f.length, f.angle / f.length};
    square = {f.scaled_inverse(0) - mean, mean - f.scaled_inverse(1)};
  }
};

template <int O, Scalar R>
HatIntegrals<O, R> hat_integrals(const Frame<R>& f) {
  return HatIntegrals<O, R>(f);
}

}  // namespace cageproof::closed_form::segment
