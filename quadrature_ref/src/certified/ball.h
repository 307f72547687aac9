// SPDX-License-Identifier: MIT
// Real and complex balls (FLINT/Arb) with the operators of numbers: every result encloses the exact one.
#pragma once

#include "cageproof/core/numbers/scalar.h"

#include <acb.h>
#include <arb.h>

#include <cmath>

namespace cageproof::quadrature_ref::certified {

/// Bits of the operators' results in this thread.
inline thread_local slong working_bits = 128;

/// Sets working_bits for a scope. `exact()`: no rounding at all, for sums and products of exact balls.
class WorkingBits {
 public:
  explicit WorkingBits(slong bits) : before_(working_bits) { working_bits = bits; }
  ~WorkingBits() { working_bits = before_; }
  WorkingBits(const WorkingBits&) = delete;
  WorkingBits& operator=(const WorkingBits&) = delete;
  static WorkingBits exact() { return WorkingBits(ARF_PREC_EXACT); }

 private:
  slong before_;
};

/// A real number known to lie within radius of midpoint.
class Real {
 public:
  Real() { arb_init(x_); }
  Real(int n) : Real() { arb_set_si(x_, n); }
  Real(const Real& o) : Real() { arb_set(x_, o.x_); }
  Real(Real&& o) noexcept : Real() { arb_swap(x_, o.x_); }
  Real& operator=(const Real& o) {
    arb_set(x_, o.x_);
    return *this;
  }
  Real& operator=(Real&& o) noexcept {
    arb_swap(x_, o.x_);
    return *this;
  }
  ~Real() { arb_clear(x_); }

  /// Exactly this scalar. \pre finite
  template <Scalar R>
  static Real exactly(const R& value) {
    Real x;
    if constexpr (is_multiprecision<R>) arf_set_mpfr(arb_midref(x.x_), value.data());
    else arf_set_d(arb_midref(x.x_), value);
    return x;
  }
  /// The ball of all numbers within `radius` (any sign, itself a ball) of this.
  Real widened(const Real& radius) const {
    Real x = *this;
    arb_add_error(x.x_, radius.x_);
    return x;
  }

  arb_ptr raw() { return x_; }
  arb_srcptr raw() const { return x_; }
  bool is_zero() const { return arb_is_zero(x_) != 0; }
  bool is_finite() const { return arb_is_finite(x_) != 0; }
  /// log2 of an upper bound of the absolute value, roughly: an estimate, no bound itself. Minus infinity for 0,
  /// infinity where there is no bound.
  double log2_size() const {
    mag_t m;
    mag_init(m);
    arb_get_mag(m, x_);
    const double log2 = mag_is_inf(m) ? HUGE_VAL : mag_get_d_log2_approx(m);
    mag_clear(m);
    return log2;
  }
  double approximate() const { return arf_get_d(arb_midref(x_), ARF_RND_NEAR); }

 private:
  arb_t x_;
};

/// A complex number known to lie in a rectangle. Square root and logarithm are indeterminate on their branch cuts.
class Complex {
 public:
  Complex() { acb_init(x_); }
  Complex(int n) : Complex() { acb_set_si(x_, n); }
  Complex(const Real& re) : Complex() { acb_set_arb(x_, re.raw()); }
  Complex(const Real& re, const Real& im) : Complex() { acb_set_arb_arb(x_, re.raw(), im.raw()); }
  Complex(const Complex& o) : Complex() { acb_set(x_, o.x_); }
  Complex(Complex&& o) noexcept : Complex() { acb_swap(x_, o.x_); }
  Complex& operator=(const Complex& o) {
    acb_set(x_, o.x_);
    return *this;
  }
  Complex& operator=(Complex&& o) noexcept {
    acb_swap(x_, o.x_);
    return *this;
  }
  ~Complex() { acb_clear(x_); }

  acb_ptr raw() { return x_; }
  acb_srcptr raw() const { return x_; }

 private:
  acb_t x_;
};

#define CAGEPROOF_BALL_OPERATOR(op, function)                      \
  inline Real operator op(const Real& a, const Real& b) {          \
    Real c;                                                        \
    arb_##function(c.raw(), a.raw(), b.raw(), working_bits);       \
    return c;                                                      \
  }                                                                \
  inline Complex operator op(const Complex& a, const Complex& b) { \
    Complex c;                                                     \
    acb_##function(c.raw(), a.raw(), b.raw(), working_bits);       \
    return c;                                                      \
  }                                                                \
  inline Complex operator op(const Complex& a, const Real& b) {    \
    Complex c;                                                     \
    acb_##function##_arb(c.raw(), a.raw(), b.raw(), working_bits); \
    return c;                                                      \
  }                                                                \
  inline Real operator op(const Real& a, int b) {                  \
    Real c;                                                        \
    arb_##function##_si(c.raw(), a.raw(), b, working_bits);        \
    return c;                                                      \
  }                                                                \
  inline Complex operator op(const Complex& a, int b) {            \
    Complex c;                                                     \
    acb_##function##_si(c.raw(), a.raw(), b, working_bits);        \
    return c;                                                      \
  }
CAGEPROOF_BALL_OPERATOR(+, add)
CAGEPROOF_BALL_OPERATOR(-, sub)
CAGEPROOF_BALL_OPERATOR(*, mul)
CAGEPROOF_BALL_OPERATOR(/, div)
#undef CAGEPROOF_BALL_OPERATOR

inline Real& operator+=(Real& a, const Real& b) {
  arb_add(a.raw(), a.raw(), b.raw(), working_bits);
  return a;
}
inline Complex& operator+=(Complex& a, const Complex& b) {
  acb_add(a.raw(), a.raw(), b.raw(), working_bits);
  return a;
}
inline void add_product(Real& sum, const Real& a, const Real& b) {
  arb_addmul(sum.raw(), a.raw(), b.raw(), working_bits);
}
inline Real operator-(const Real& a) {
  Real c;
  arb_neg(c.raw(), a.raw());
  return c;
}

inline Real sqrt(const Real& a) {
  Real c;
  arb_sqrt(c.raw(), a.raw(), working_bits);
  return c;
}
inline Complex sqrt(const Complex& a) {
  Complex c;
  acb_sqrt_analytic(c.raw(), a.raw(), 1, working_bits);
  return c;
}
inline Real log(const Real& a) {
  Real c;
  arb_log(c.raw(), a.raw(), working_bits);
  return c;
}
inline Real log1p(const Real& a) {
  Real c;
  arb_log1p(c.raw(), a.raw(), working_bits);
  return c;
}
inline Complex log(const Complex& a) {
  Complex c;
  acb_log_analytic(c.raw(), a.raw(), 1, working_bits);
  return c;
}
inline void sinh_cosh(const Real& a, Real& s, Real& c) { arb_sinh_cosh(s.raw(), c.raw(), a.raw(), working_bits); }
inline void sinh_cosh(const Complex& a, Complex& s, Complex& c) {
  acb_sinh_cosh(s.raw(), c.raw(), a.raw(), working_bits);
}
inline Real asinh(const Real& a) {
  Real c;
  arb_asinh(c.raw(), a.raw(), working_bits);
  return c;
}
/// atan(y/x) for x > 0.
inline Real angle(const Real& y, const Real& x) {
  Real c;
  arb_atan(c.raw(), Real(y / x).raw(), working_bits);
  return c;
}
/// The continuation of atan(y/x), x > 0, to Re y > 0: (log(x + iy) - log(x - iy)) / 2i.
inline Complex angle(const Complex& y, const Real& x) {
  Complex iy;
  acb_mul_onei(iy.raw(), y.raw());
  Complex c = log(Complex(x) + iy) - log(Complex(x) - iy);
  acb_div_onei(c.raw(), c.raw());
  return c / 2;
}
inline Real pi_ball() {
  Real c;
  arb_const_pi(c.raw(), working_bits);
  return c;
}

/// An upper bound of the absolute value, as an exact ball (not finite where there is none).
inline Real upper_bound(const Real& a) {
  Real c;
  arb_get_abs_ubound_arf(arb_midref(c.raw()), a.raw(), MAG_BITS);
  return c;
}
inline Real upper_bound(const Complex& a) {
  Real c;
  acb_get_abs_ubound_arf(arb_midref(c.raw()), a.raw(), MAG_BITS);
  return c;
}

}  // namespace cageproof::quadrature_ref::certified
