// SPDX-License-Identifier: MIT
// Functions of a point and its conjugate, with their derivatives by both, and the real ones that follow.
#pragma once

#include "complex.h"

namespace cageproof::solved::goursat {

/// F(z, w) where w is the conjugate of z, and its derivatives as if both were independent. The real part of F is
/// biharmonic where F = w phi(z) + chi(z), or the same with z and w exchanged.
template <class R>
struct GoursatJet {
  Complex<R> value, z, w, zz, zw, ww;

  friend GoursatJet operator*(const Complex<R>& a, const GoursatJet& b) {
    return {a * b.value, a * b.z, a * b.w, a * b.zz, a * b.zw, a * b.ww};
  }
};

/// z -> turn z for a `turn` of unit length: derivatives by z of what is given as a function of turn z.
template <class R>
GoursatJet<R> in_frame(const GoursatJet<R>& f, const Complex<R>& turn) {
  const Complex<R> back = conj(turn);
  return {f.value, turn * f.z, back * f.w, turn * turn * f.zz, f.zw, back * back * f.ww};
}

/// w g(z), from g and its first two derivatives.
template <class R>
GoursatJet<R> times_conjugate(const Complex<R>& w, const Complex<R>& g, const Complex<R>& dg, const Complex<R>& ddg) {
  return {w * g, w * dg, g, w * ddg, dg, Complex<R>()};
}

/// g(z), from g and its first two derivatives.
template <class R>
GoursatJet<R> holomorphic(const Complex<R>& g, const Complex<R>& dg, const Complex<R>& ddg) {
  return {g, dg, Complex<R>(), ddg, Complex<R>(), Complex<R>()};
}

/// Rows of real functions' values and derivatives, one column per function: f; f_x, f_y; f_xx, f_xy, f_yy.
template <class R>
class RowWriter {
 public:
  /// \param rows row by row, `columns` numbers each: 1, 3 or 6 of them
  RowWriter(R* rows, int columns, int order) : next_(rows), columns_(columns), order_(order) {}

  int order() const { return order_; }
  /// The real part of f.
  void put(const GoursatJet<R>& f) {
    next_[0] = f.value.re;
    if (order_ >= 1) {
      next_[columns_] = f.z.re + f.w.re;
      next_[2 * columns_] = f.w.im - f.z.im;
    }
    if (order_ >= 2) {
      next_[3 * columns_] = f.zz.re + 2 * f.zw.re + f.ww.re;
      next_[4 * columns_] = f.ww.im - f.zz.im;
      next_[5 * columns_] = 2 * f.zw.re - f.zz.re - f.ww.re;
    }
    ++next_;
  }
  /// The real parts of f and i f.
  void put_both(const GoursatJet<R>& f) {
    put(f);
    put(Complex<R>(R(0), R(1)) * f);
  }

 private:
  R* next_;
  std::ptrdiff_t columns_;
  int order_;
};

}  // namespace cageproof::solved::goursat
