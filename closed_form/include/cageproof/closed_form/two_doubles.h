// SPDX-License-Identifier: MIT
// Twice the digits of double, from pairs of doubles.
#pragma once

#include "cageproof/core/scalar.h"

#include <cmath>

namespace cageproof::closed_form {

/// The unevaluated sum of two doubles: relative error at most 2^-100 an operation (Dekker 1971, Knuth's two-sum), range of a double.
/// Logarithms and angles go through MPFR.
struct TwoDoubles {
  double high = 0;
  double low = 0;

  TwoDoubles() = default;
  TwoDoubles(double h, double l = 0) : high(h), low(l) {}
  /// Rounded to nearest from any multiprecision number.
  template <class M>
    requires is_multiprecision<M>
  explicit TwoDoubles(const M& x) : high(static_cast<double>(x)), low(static_cast<double>(M(x - high))) {}
  explicit operator double() const { return high + low; }

  /// a + b, exactly.
  static TwoDoubles sum(double a, double b) {
    const double s = a + b;
    const double t = s - a;
    return {s, (a - (s - t)) + (b - t)};
  }
  friend TwoDoubles operator+(const TwoDoubles& a, const TwoDoubles& b) {
    TwoDoubles s = sum(a.high, b.high);
    const TwoDoubles t = sum(a.low, b.low);
    s = sum(s.high, s.low + t.high);
    return sum(s.high, s.low + t.low);
  }
  friend TwoDoubles operator-(const TwoDoubles& a) { return {-a.high, -a.low}; }
  friend TwoDoubles operator-(const TwoDoubles& a, const TwoDoubles& b) { return a + (-b); }
  friend TwoDoubles operator*(const TwoDoubles& a, const TwoDoubles& b) {
    const double p = a.high * b.high;
    return sum(p, std::fma(a.high, b.high, -p) + (a.high * b.low + a.low * b.high));
  }
  friend TwoDoubles operator/(const TwoDoubles& a, const TwoDoubles& b) {
    const double first = a.high / b.high;
    const TwoDoubles rest = a - b * first;
    const double second = rest.high / b.high;
    return TwoDoubles(first) + TwoDoubles(second) + TwoDoubles((rest - b * second).high / b.high);
  }
  TwoDoubles& operator+=(const TwoDoubles& b) { return *this = *this + b; }
  TwoDoubles& operator-=(const TwoDoubles& b) { return *this = *this - b; }
  TwoDoubles& operator*=(const TwoDoubles& b) { return *this = *this * b; }
  TwoDoubles& operator/=(const TwoDoubles& b) { return *this = *this / b; }
  friend bool operator==(const TwoDoubles& a, const TwoDoubles& b) { return a.high == b.high && a.low == b.low; }
  friend bool operator<(const TwoDoubles& a, const TwoDoubles& b) {
    return a.high < b.high || (a.high == b.high && a.low < b.low);
  }
  friend bool operator>(const TwoDoubles& a, const TwoDoubles& b) { return b < a; }
  friend bool operator<=(const TwoDoubles& a, const TwoDoubles& b) { return a < b || a == b; }
  friend bool operator>=(const TwoDoubles& a, const TwoDoubles& b) { return b <= a; }

  friend TwoDoubles abs(const TwoDoubles& a) { return a.high < 0 ? -a : a; }
  friend TwoDoubles sqrt(const TwoDoubles& a) {
    if (a.high == 0) return a;
    const double root = std::sqrt(a.high);
    return sum(root, (a - TwoDoubles(root) * root).high / (2 * root));
  }
  friend TwoDoubles log(const TwoDoubles& a) { return TwoDoubles(Mp50(log(wide(a)))); }
  friend TwoDoubles atanh(const TwoDoubles& a) { return TwoDoubles(Mp50(atanh(wide(a)))); }
  friend TwoDoubles atan2(const TwoDoubles& y, const TwoDoubles& x) { return TwoDoubles(Mp50(atan2(wide(y), wide(x)))); }

 private:
  static Mp50 wide(const TwoDoubles& a) { return Mp50(a.high) + a.low; }
};

}  // namespace cageproof::closed_form
