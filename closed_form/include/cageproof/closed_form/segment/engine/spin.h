// SPDX-License-Identifier: MIT
// Symmetric matrices without trace, which tensors in the plane are made of, as complex numbers.
#pragma once

#include "cageproof/closed_form/segment/engine/frame.h"

namespace cageproof::closed_form::segment {

/// Re c (u u' - n n') + Im c (u n' + n u'), entry by entry. Of x x'/r^2 the part without trace is half of that of
/// c = z/conj(z), of (I - 2 x x'/r^2)/r^2 it is minus that of 1/conj(z)^2.
template <Scalar R>
struct Spin {
  R diagonal, mixed;  ///< entry (0, 0), which is minus entry (1, 1), and entries (0, 1) and (1, 0)

  Spin(const Frame<R>& f, const Complex<R>& c) {
    // n = (u[1], -u[0]).
    const R twice = 2 * f.u[0] * f.u[1], difference = (f.u[0] - f.u[1]) * (f.u[0] + f.u[1]);
    diagonal = c.re * difference + c.im * twice;
    mixed = c.re * twice - c.im * difference;
  }
  R operator()(int row, int column) const {
    if (row != column) return mixed;
    return row == 0 ? diagonal : R(-diagonal);
  }
};

template <class R>
Complex<R> conjugate(const Complex<R>& c) {
  return {c.re, -c.im};
}

/// i c.
template <class R>
Complex<R> turned(const Complex<R>& c) {
  return {-c.im, c.re};
}

}  // namespace cageproof::closed_form::segment
