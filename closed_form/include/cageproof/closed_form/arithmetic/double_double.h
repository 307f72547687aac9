// SPDX-License-Identifier: MIT
// Twice the digits of double.
#pragma once

#include "cageproof/core/numbers/scalar.h"

#include <cmath>

namespace cageproof::closed_form {

/// The unevaluated sum of two doubles: relative error at most 2^-100 an operation (Dekker 1971, Knuth's two-sum), range
/// of a double.
struct DoubleDouble {
  double high = 0;
  double low = 0;

  DoubleDouble() = default;
  DoubleDouble(double h, double l = 0) : high(h), low(l) {}
  /// Rounded to nearest from any multiprecision number.
  template <class M>
  requires is_multiprecision<M>
  explicit DoubleDouble(const M& x) : high(static_cast<double>(x)), low(static_cast<double>(M(x - high))) {}
  explicit operator double() const { return high + low; }

  /// a + b, exactly.
  static DoubleDouble sum(double a, double b) {
    const double s = a + b;
    const double t = s - a;
    return {s, (a - (s - t)) + (b - t)};
  }
  friend DoubleDouble operator+(const DoubleDouble& a, const DoubleDouble& b) {
    DoubleDouble s = sum(a.high, b.high);
    const DoubleDouble t = sum(a.low, b.low);
    s = sum(s.high, s.low + t.high);
    return sum(s.high, s.low + t.low);
  }
  friend DoubleDouble operator-(const DoubleDouble& a) { return {-a.high, -a.low}; }
  friend DoubleDouble operator-(const DoubleDouble& a, const DoubleDouble& b) { return a + (-b); }
  friend DoubleDouble operator*(const DoubleDouble& a, const DoubleDouble& b) {
    const double p = a.high * b.high;
    return sum(p, product_rest(a.high, b.high, p) + (a.high * b.low + a.low * b.high));
  }
  friend DoubleDouble operator/(const DoubleDouble& a, const DoubleDouble& b) {
    const double first = a.high / b.high;
    const DoubleDouble rest = a - b * first;
    const double second = rest.high / b.high;
    return DoubleDouble(first) + DoubleDouble(second) + DoubleDouble((rest - b * second).high / b.high);
  }
  DoubleDouble& operator+=(const DoubleDouble& b) { return *this = *this + b; }
  DoubleDouble& operator-=(const DoubleDouble& b) { return *this = *this - b; }
  DoubleDouble& operator*=(const DoubleDouble& b) { return *this = *this * b; }
  DoubleDouble& operator/=(const DoubleDouble& b) { return *this = *this / b; }
  friend bool operator==(const DoubleDouble& a, const DoubleDouble& b) { return a.high == b.high && a.low == b.low; }
  friend bool operator<(const DoubleDouble& a, const DoubleDouble& b) {
    return a.high < b.high || (a.high == b.high && a.low < b.low);
  }
  friend bool operator>(const DoubleDouble& a, const DoubleDouble& b) { return b < a; }
  friend bool operator<=(const DoubleDouble& a, const DoubleDouble& b) { return a < b || a == b; }
  friend bool operator>=(const DoubleDouble& a, const DoubleDouble& b) { return b <= a; }

  friend DoubleDouble abs(const DoubleDouble& a) { return a.high < 0 ? -a : a; }
  friend DoubleDouble sqrt(const DoubleDouble& a) {
    if (a.high == 0) return a;
    const double root = std::sqrt(a.high);
    return sum(root, (a - DoubleDouble(root) * root).high / (2 * root));
  }

 private:
  /// a b - p, exactly, p being a b rounded. Where the compiler may not assume the machine to have the operation,
  /// Dekker's halves of 26 bits are quicker than a call.
  static double product_rest(double a, double b, double p) {
#if defined(__FMA__) || defined(__ARM_FEATURE_FMA)
    return std::fma(a, b, -p);
#else
    constexpr double kHalf = 0x1p27 + 1, kLargest = 0x1p990;
    if (!(std::abs(a) < kLargest && std::abs(b) < kLargest)) return std::fma(a, b, -p);
    const double ta = a * kHalf, tb = b * kHalf;
    const double ah = ta - (ta - a), al = a - ah, bh = tb - (tb - b), bl = b - bh;
    return ((ah * bh - p) + ah * bl + al * bh) + al * bl;
#endif
  }
};

/// To four times the error of an operation. Of numbers next to the ends of the range, and of zeros, through MPFR.
DoubleDouble log(const DoubleDouble& a);
DoubleDouble atanh(const DoubleDouble& a);
DoubleDouble atan2(const DoubleDouble& y, const DoubleDouble& x);

}  // namespace cageproof::closed_form
