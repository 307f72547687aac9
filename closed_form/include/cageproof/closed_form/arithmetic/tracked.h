// SPDX-License-Identifier: MIT
// A number that carries a bound of its own rounding error: running error analysis.
#pragma once

#include "cageproof/closed_form/arithmetic/constants.h"
#include "cageproof/closed_form/arithmetic/double_double.h"
#include "cageproof/closed_form/arithmetic/names.h"
#include "cageproof/core/linear.h"

#include <algorithm>
#include <limits>

namespace cageproof::closed_form {

/// u of a type: what one operation may be wrong by, relatively.
template <class T>
double roundoff_of() {
  // Division is a double-double's least exact operation: it loses four of the 106 bits.
  if constexpr (std::same_as<T, DoubleDouble>) return 0x1p-100;
  else return static_cast<double>(T(std::numeric_limits<T>::epsilon() / 2));
}

/// What errors of a type are counted in: powers of distances that multiprecision holds may leave double's range.
template <class T>
using ErrorOf = std::conditional_t<is_multiprecision<T>, long double, double>;

/// |x| in the type of errors.
template <class T>
ErrorOf<T> size_of(const T& x) {
  if constexpr (is_multiprecision<T>) return std::abs(mpfr_get_ld(x.data(), MPFR_RNDN));
  else return std::abs(static_cast<double>(x));
}

/// A value of type T and a bound of its absolute error in units of roundoff_of<T>() (Wilkinson 1986; Higham 2002,
/// Section 3.3): every operation adds its own rounding to what it passes on. The bound itself is rounded, which is why
/// acceptance leaves room.
template <class T>
struct Tracked {
  using Error = ErrorOf<T>;

  T value{};
  Error error = 0;

  Tracked() = default;
  /// An exact number.
  Tracked(int x) : value(x) {}
  Tracked(double x) : value(x) {}
  Tracked(const T& v, Error e) : value(v), error(e) {}

  explicit operator double() const { return static_cast<double>(value); }

  Error magnitude() const { return size_of(value); }
  static Tracked rounded(const T& v, Error e, double roundings = 1) { return {v, e + roundings * size_of(v)}; }
  static Tracked pi() { return rounded(T(cageproof::pi<Mp200>()), 0); }
  static Tracked ln_two() { return rounded(T(cageproof::ln_two<Mp200>()), 0); }

  friend Tracked operator-(const Tracked& a) { return {T(-a.value), a.error}; }
  friend Tracked operator+(const Tracked& a, const Tracked& b) {
    return rounded(T(a.value + b.value), a.error + b.error);
  }
  friend Tracked operator-(const Tracked& a, const Tracked& b) {
    return rounded(T(a.value - b.value), a.error + b.error);
  }
  friend Tracked operator*(const Tracked& a, const Tracked& b) {
    return rounded(T(a.value * b.value),
                   a.magnitude() * b.error + b.magnitude() * a.error + roundoff_of<T>() * a.error * b.error);
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
    const Error size = size_of(root);
    return rounded(root, a.error == 0 ? 0 : a.error / (size + std::sqrt(remaining(a))));
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
    return rounded(T(atan2(y.value, x.value)),
                   (a / reach * y.error + b / reach * x.error) / remaining(reach, std::hypot(x.error, y.error)),
                   kFunctionRoundings);
  }

 private:
  /// Mathematical libraries promise an ulp or two for logarithms and angles, not half of one.
  static constexpr double kFunctionRoundings = 4;
  /// The magnitude less its own error: what a divisor may have shrunk to; zero where nothing of it is certain.
  static Error remaining(const Tracked& a) { return remaining(a.magnitude(), a.error); }
  static Error remaining(Error magnitude, Error error) {
    return std::max(Error(0), magnitude - static_cast<Error>(roundoff_of<T>()) * error);
  }
};

}  // namespace cageproof::closed_form

/// Infinities, and what is no number.
template <class T>
class std::numeric_limits<cageproof::closed_form::Tracked<T>> : public std::numeric_limits<T> {};

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
