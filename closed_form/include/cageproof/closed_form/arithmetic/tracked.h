// SPDX-License-Identifier: MIT
// A number that carries a bound of its own rounding error: running error analysis.
#pragma once

#include "cageproof/closed_form/arithmetic/constants.h"
#include "cageproof/closed_form/arithmetic/double_double.h"
#include "cageproof/closed_form/arithmetic/names.h"
#include "cageproof/core/numbers/linear.h"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <limits>

namespace cageproof::closed_form {

/// The type that holds errors of T: errors of powers of distances in multiprecision may leave double's range.
template <class T>
using ErrorOf = std::conditional_t<is_multiprecision<T>, long double, double>;

/// u of a type: a bound of the relative error of one operation.
template <class T>
constexpr ErrorOf<T> roundoff_of() {
  // A double-double has 106 bits; every operation keeps 100 of them (double_double.h).
  int bits = std::same_as<T, DoubleDouble> ? 100 : std::numeric_limits<T>::digits;
  ErrorOf<T> u = 1;
  for (; bits > 0; --bits) u /= 2;
  return u;
}

/// |x| in the type of errors, or, of multiprecision, the power of two above it: at most twice as much, and quick.
template <class T>
ErrorOf<T> size_of(const T& x) {
  if constexpr (is_multiprecision<T>) {
    const std::int64_t exponent = x.exponent();
    if (exponent == T::kNoExponent) return std::abs(static_cast<long double>(x));
    // Within double's range its bits are quicker.
    if (exponent > -1000 && exponent < 1000)
      return std::bit_cast<double>(static_cast<std::uint64_t>(exponent + 1023) << 52);
    return std::ldexp(1.0L, static_cast<int>(exponent));
  } else {
    return std::abs(static_cast<double>(x));
  }
}
/// No more than |x|: as size_of, from below.
template <class T>
ErrorOf<T> least_size_of(const T& x) {
  return is_multiprecision<T> ? size_of(x) / 2 : size_of(x);
}

/// A value of type T and a bound of its absolute error in units of roundoff_of<T>() (Wilkinson 1986; Higham 2002,
/// Section 3.3): every operation adds its own rounding to what it passes on. The bound itself is rounded, which is why
/// acceptance leaves room. Comparisons look only at values: callers branch on numbers whose signs are certain, such as
/// heights from exact geometry, or between forms that both hold at the border.
template <class T>
struct Tracked {
  using Error = ErrorOf<T>;

  T value{};
  Error error = 0;

  Tracked() = default;
  /// Exact numbers: the error is zero, so do not pass a rounded double.
  Tracked(int x) : value(x) {}
  Tracked(double x) : value(x) {}
  Tracked(const T& v, Error e) : value(v), error(e) {}

  explicit operator double() const { return static_cast<double>(value); }

  Error magnitude() const { return size_of(value); }
  static Tracked rounded(const T& v, Error e, double roundings = 1) { return {v, e + roundings * size_of(v)}; }
  static Tracked pi() { return rounded(T(Constants::pi()), 0); }
  static Tracked ln_two() { return rounded(T(Constants::ln_two()), 0); }

  friend Tracked operator-(const Tracked& a) { return {T(-a.value), a.error}; }
  friend Tracked operator+(const Tracked& a, const Tracked& b) {
    return rounded(T(a.value + b.value), a.error + b.error);
  }
  friend Tracked operator-(const Tracked& a, const Tracked& b) {
    return rounded(T(a.value - b.value), a.error + b.error);
  }
  friend Tracked operator*(const Tracked& a, const Tracked& b) {
    return rounded(T(a.value * b.value),
                   a.magnitude() * b.error + b.magnitude() * a.error + kRoundoff * a.error * b.error);
  }
  friend Tracked operator/(const Tracked& a, const Tracked& b) {
    const T quotient = a.value / b.value;
    const Error size = size_of(quotient);
    return rounded(quotient, (a.error + size * b.error) / remaining(b));
  }
  Tracked& operator+=(const Tracked& b) { return *this = *this + b; }
  Tracked& operator-=(const Tracked& b) { return *this = *this - b; }
  Tracked& operator*=(const Tracked& b) { return *this = *this * b; }
  Tracked& operator/=(const Tracked& b) { return *this = *this / b; }
  friend bool operator==(const Tracked& a, const Tracked& b) { return a.value == b.value; }
  friend bool operator<(const Tracked& a, const Tracked& b) { return a.value < b.value; }
  friend bool operator>(const Tracked& a, const Tracked& b) { return b.value < a.value; }
  friend bool operator<=(const Tracked& a, const Tracked& b) { return a.value <= b.value; }
  friend bool operator>=(const Tracked& a, const Tracked& b) { return b.value <= a.value; }

  friend Tracked abs(const Tracked& a) { return a.value < T(0) ? -a : a; }
  friend Tracked sqrt(const Tracked& a) {
    using std::sqrt;
    const T root = sqrt(a.value);
    return rounded(root, a.error == 0 ? 0 : a.error / (least_size_of(root) + std::sqrt(remaining(a))));
  }
  friend Tracked log(const Tracked& a) {
    using std::log;
    return rounded(T(log(a.value)), a.error / remaining(a), kFunctionRoundings);
  }
  friend Tracked log1p(const Tracked& a) {
    using std::log1p;
    return rounded(T(log1p(a.value)), a.error / remaining(Tracked(T(T(1) + a.value), a.error)), kFunctionRoundings);
  }
  friend Tracked atanh(const Tracked& a) {
    using std::atanh;
    return rounded(T(atanh(a.value)), a.error / remaining(Tracked(T(T(1) - a.value * a.value), 2 * a.error)),
                   kFunctionRoundings);
  }
  friend Tracked atan2(const Tracked& y, const Tracked& x) {
    using std::atan2;
    const Error a = x.magnitude(), b = y.magnitude(), reach = std::hypot(a, b);
    const Error least = is_multiprecision<T> ? reach / 2 : reach;
    return rounded(T(atan2(y.value, x.value)),
                   (a / reach * y.error + b / reach * x.error) / remaining(least, std::hypot(x.error, y.error)),
                   kFunctionRoundings);
  }

 private:
  static constexpr Error kRoundoff = roundoff_of<T>();
  /// Mathematical libraries promise an ulp or two for logarithms and angles, not half of one.
  static constexpr double kFunctionRoundings = 4;
  // Constants of 200 digits serve double-doubles and narrower types.
  using Constants = MpConstants<std::max(200, std::numeric_limits<T>::digits10)>;
  /// The magnitude less its own error, the least size that a divisor may have; zero where not even its sign is certain.
  static Error remaining(const Tracked& a) { return remaining(least_size_of(a.value), a.error); }
  static Error remaining(Error magnitude, Error error) { return std::max(Error(0), magnitude - kRoundoff * error); }
};

}  // namespace cageproof::closed_form

/// Infinities and NaN have no error.
template <class T>
class std::numeric_limits<cageproof::closed_form::Tracked<T>> : public std::numeric_limits<T> {
  using Tracked = cageproof::closed_form::Tracked<T>;

 public:
  static Tracked infinity() { return {std::numeric_limits<T>::infinity(), 0}; }
  static Tracked quiet_NaN() { return {std::numeric_limits<T>::quiet_NaN(), 0}; }
};

namespace Eigen {
template <class T>
struct NumTraits<cageproof::closed_form::Tracked<T>> : GenericNumTraits<cageproof::closed_form::Tracked<T>> {
  enum {
    IsInteger = 0,
    IsSigned = 1,
    IsComplex = 0,
    RequireInitialization = 1,
    ReadCost = 2,
    AddCost = 8,
    MulCost = 8
  };
};
}  // namespace Eigen
