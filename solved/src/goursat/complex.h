// SPDX-License-Identifier: MIT
// Complex numbers over any scalar. std::complex is specified only for the built-in types, and checks each product for
// infinities.
#pragma once

#include "cageproof/core/numbers/scalar.h"

#include <cmath>

namespace cageproof::solved::goursat {

template <class R>
struct Complex {
  R re{0}, im{0};

  Complex() = default;
  Complex(const R& real) : re(real) {}
  Complex(const R& real, const R& imaginary) : re(real), im(imaginary) {}

  friend Complex operator+(const Complex& a, const Complex& b) { return {R(a.re + b.re), R(a.im + b.im)}; }
  friend Complex operator-(const Complex& a, const Complex& b) { return {R(a.re - b.re), R(a.im - b.im)}; }
  friend Complex operator-(const Complex& a) { return {R(-a.re), R(-a.im)}; }
  friend Complex operator*(const Complex& a, const Complex& b) {
    return {R(a.re * b.re - a.im * b.im), R(a.re * b.im + a.im * b.re)};
  }
  friend Complex operator*(const R& a, const Complex& b) { return {R(a * b.re), R(a * b.im)}; }
  friend Complex operator/(const Complex& a, const Complex& b) {
    const R square = b.re * b.re + b.im * b.im;
    return {R((a.re * b.re + a.im * b.im) / square), R((a.im * b.re - a.re * b.im) / square)};
  }
};

template <class R>
Complex<R> conj(const Complex<R>& a) {
  return {a.re, R(-a.im)};
}

/// i a.
template <class R>
Complex<R> turned(const Complex<R>& a) {
  return {R(-a.im), a.re};
}

template <class R>
Complex<R> exp(const Complex<R>& a) {
  using std::cos, std::exp, std::sin;
  const R length = exp(a.re);
  return {R(length * cos(a.im)), R(length * sin(a.im))};
}

template <class To, class From>
Complex<To> converted(const Complex<From>& a) {
  return {static_cast<To>(a.re), static_cast<To>(a.im)};
}

}  // namespace cageproof::solved::goursat
