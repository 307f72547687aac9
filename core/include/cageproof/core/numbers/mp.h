// SPDX-License-Identifier: MIT
// The multiprecision numbers, as a type of few operators whose work is compiled once, in mp.cpp.
//
// Boost.Multiprecision does the work there. Its own headers and operators are not for every file: half of the time that
// a formula took to compile went into choosing among their overloads and into copies of what they inline.
#pragma once

#include "cageproof/core/numbers/mp_names.h"

#ifndef CAGEPROOF_NO_MPFR
#include <mpfr.h>
#endif

#include <array>
#include <compare>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <iosfwd>
#include <limits>
#include <string>
#include <type_traits>

namespace cageproof {

template <class T>
concept BuiltinNumber =
    std::integral<T> || std::same_as<T, float> || std::same_as<T, double> || std::same_as<T, long double>;

/// A binary floating-point number with `Digits` decimal digits: 50, 100, 200, 400, 800 or 2000. Every operation and
/// function is MPFR's, rounded to nearest; it lies in place, without memory of its own. Built-in numbers are taken
/// exactly. The default is zero.
///
/// Where CAGEPROOF_NO_MPFR is defined, Boost's cpp_bin_float does the work with as many bits: sums, differences,
/// products, quotients and square roots are the same to the last bit. Other functions are computed in 64 bits more and
/// rounded then, so that they too are the nearest numbers, except in one case of 2^50 or so. Exponents have 32 bits
/// there.
template <unsigned Digits>
class Mp {
 public:
  /// Bits of the significand.
  static constexpr unsigned bits = Digits * 1000 / 301 + (Digits * 1000 % 301 != 0 ? 2 : 1);

  Mp();
  Mp(const Mp& other);
  Mp& operator=(const Mp& other);
  template <BuiltinNumber T>
  Mp(T value) : Mp(Exactly(), widest(value)) {}
  /// Exact from fewer digits, rounded from more.
  template <unsigned More>
  explicit(More > Digits) Mp(const Mp<More>& other);
  /// From a decimal. \throws std::runtime_error if the text is no number
  explicit Mp(const char* text);
  explicit Mp(const std::string& text) : Mp(text.c_str()) {}

  /// Rounded to nearest, or towards zero to an integer.
  template <BuiltinNumber T>
  explicit operator T() const {
    if constexpr (std::same_as<T, bool>) return !is_zero();
    else if constexpr (std::same_as<T, float>) return to_float();
    else if constexpr (std::same_as<T, double>) return to_double();
    else if constexpr (std::same_as<T, long double>) return to_long_double();
    else if constexpr (std::is_signed_v<T>) return static_cast<T>(to_integer());
    else return static_cast<T>(to_unsigned());
  }

  Mp& operator+=(const Mp& b);
  Mp& operator-=(const Mp& b);
  Mp& operator*=(const Mp& b);
  Mp& operator/=(const Mp& b);

  bool is_zero() const;
  /// The e of a number whose size is at least 2^(e-1) and below 2^e; kNoExponent of zero, infinity and NaN.
  std::int64_t exponent() const;
  static constexpr std::int64_t kNoExponent = std::numeric_limits<std::int64_t>::max();

#ifndef CAGEPROOF_NO_MPFR
  /// The pointer that MPFR's functions take, to a number of `bits` bits.
  mpfr_ptr data();
  mpfr_srcptr data() const;
#endif
  /// Where Boost's number lies, for mp_number.h.
  void* number() { return &number_; }
  const void* number() const { return &number_; }

 private:
  struct Exactly {};
  Mp(Exactly, double value);
  Mp(Exactly, long double value);
  Mp(Exactly, long long value);
  Mp(Exactly, unsigned long long value);
  template <BuiltinNumber T>
  static constexpr auto widest(T value) {
    if constexpr (std::same_as<T, long double>) return value;
    else if constexpr (std::floating_point<T>) return static_cast<double>(value);
    else if constexpr (std::is_signed_v<T>) return static_cast<long long>(value);
    else return static_cast<unsigned long long>(value);
  }
  float to_float() const;
  double to_double() const;
  long double to_long_double() const;
  long long to_integer() const;
  unsigned long long to_unsigned() const;
  std::byte* limbs() { return number_.data() + kHead; }

  // A number of Boost's: MPFR's 32 bytes of precision, sign, exponent and pointer, then the limbs; or limbs, then as
  // much for their count, the exponent and the sign. Nothing to destroy.
  static constexpr std::size_t kHead = 32, size = kHead + (bits + 63) / 64 * 8;
#ifdef CAGEPROOF_NO_MPFR
  alignas(16) std::array<std::byte, size> number_;
#else
  alignas(8) std::array<std::byte, size> number_;
#endif
};

template <unsigned D>
Mp<D> operator+(const Mp<D>& a, const Mp<D>& b);
template <unsigned D>
Mp<D> operator-(const Mp<D>& a, const Mp<D>& b);
template <unsigned D>
Mp<D> operator*(const Mp<D>& a, const Mp<D>& b);
template <unsigned D>
Mp<D> operator/(const Mp<D>& a, const Mp<D>& b);
template <unsigned D>
Mp<D> operator-(const Mp<D>& a);
template <unsigned D>
Mp<D> operator+(const Mp<D>& a) {
  return a;
}
template <unsigned D>
bool operator==(const Mp<D>& a, const Mp<D>& b);
template <unsigned D>
std::partial_ordering operator<=>(const Mp<D>& a, const Mp<D>& b);

// Built-in numbers are exact in any of the types, so that rounding happens once here too.
template <unsigned D, BuiltinNumber T>
Mp<D> operator+(const Mp<D>& a, T b) {
  return a + Mp<D>(b);
}
template <unsigned D, BuiltinNumber T>
Mp<D> operator+(T a, const Mp<D>& b) {
  return Mp<D>(a) + b;
}
template <unsigned D, BuiltinNumber T>
Mp<D> operator-(const Mp<D>& a, T b) {
  return a - Mp<D>(b);
}
template <unsigned D, BuiltinNumber T>
Mp<D> operator-(T a, const Mp<D>& b) {
  return Mp<D>(a) - b;
}
template <unsigned D, BuiltinNumber T>
Mp<D> operator*(const Mp<D>& a, T b) {
  return a * Mp<D>(b);
}
template <unsigned D, BuiltinNumber T>
Mp<D> operator*(T a, const Mp<D>& b) {
  return Mp<D>(a) * b;
}
template <unsigned D, BuiltinNumber T>
Mp<D> operator/(const Mp<D>& a, T b) {
  return a / Mp<D>(b);
}
template <unsigned D, BuiltinNumber T>
Mp<D> operator/(T a, const Mp<D>& b) {
  return Mp<D>(a) / b;
}
template <unsigned D, BuiltinNumber T>
bool operator==(const Mp<D>& a, T b) {
  return a == Mp<D>(b);
}
template <unsigned D, BuiltinNumber T>
std::partial_ordering operator<=>(const Mp<D>& a, T b) {
  return a <=> Mp<D>(b);
}

// <cmath>'s functions, with the names and meanings they have there.
#define CAGEPROOF_MP_FUNCTIONS(apply)                                                                           \
  apply(abs) apply(fabs) apply(sqrt) apply(cbrt) apply(exp) apply(expm1) apply(log) apply(log1p) apply(log2)    \
      apply(log10) apply(sin) apply(cos) apply(tan) apply(asin) apply(acos) apply(atan) apply(sinh) apply(cosh) \
          apply(tanh) apply(asinh) apply(acosh) apply(atanh) apply(floor) apply(ceil) apply(trunc) apply(round)
#define CAGEPROOF_MP_DECLARE(name) \
  template <unsigned D>            \
  Mp<D> name(const Mp<D>& x);
CAGEPROOF_MP_FUNCTIONS(CAGEPROOF_MP_DECLARE)
#undef CAGEPROOF_MP_DECLARE

template <unsigned D>
Mp<D> pow(const Mp<D>& x, const Mp<D>& y);
template <unsigned D>
Mp<D> pow(const Mp<D>& x, int n);
template <unsigned D>
Mp<D> atan2(const Mp<D>& y, const Mp<D>& x);
template <unsigned D>
Mp<D> hypot(const Mp<D>& x, const Mp<D>& y);
template <unsigned D>
Mp<D> copysign(const Mp<D>& x, const Mp<D>& sign);
template <unsigned D>
Mp<D> ldexp(const Mp<D>& x, int exponent);
template <unsigned D>
Mp<D> frexp(const Mp<D>& x, int* exponent);
template <unsigned D>
int ilogb(const Mp<D>& x);
template <unsigned D>
bool isnan(const Mp<D>& x);
template <unsigned D>
bool isinf(const Mp<D>& x);
template <unsigned D>
bool isfinite(const Mp<D>& x);
template <unsigned D>
bool signbit(const Mp<D>& x);

template <unsigned D>
std::ostream& operator<<(std::ostream& out, const Mp<D>& x);

/// Correctly rounded constants, and the ends of the range.
template <unsigned D>
struct MpConstants {
  static const Mp<D>&pi(), &ln_two(), &epsilon(), &smallest(), &largest(), &infinity(), &nan();
};

}  // namespace cageproof

template <unsigned D>
class std::numeric_limits<cageproof::Mp<D>> {
  using R = cageproof::Mp<D>;
  using Constants = cageproof::MpConstants<D>;

 public:
  static constexpr bool is_specialized = true, is_signed = true, is_integer = false, is_exact = false,
                        has_infinity = true, has_quiet_NaN = true, has_signaling_NaN = false, is_iec559 = false,
                        is_bounded = true, is_modulo = false, traps = true, tinyness_before = false;
  static constexpr int digits = R::bits, digits10 = D, max_digits10 = D + 3, radix = 2;
  static constexpr std::float_round_style round_style = std::round_to_nearest;
  static R epsilon() { return Constants::epsilon(); }
  static R min() { return Constants::smallest(); }
  static R max() { return Constants::largest(); }
  static R lowest() { return -Constants::largest(); }
  static R infinity() { return Constants::infinity(); }
  static R quiet_NaN() { return Constants::nan(); }
};
