// SPDX-License-Identifier: MIT
// A double with its exact value next to it, and a record of every operation on it with the operation's source line.
#pragma once

#include "cageproof/closed_form/arithmetic/taylor.h"
#include "cageproof/core/numbers/linear.h"

#include <cmath>
#include <cstdint>
#include <limits>
#include <source_location>

namespace cageproof::closed_form {

class Counted;
/// For templates over scalars a Counted is a double: they take the same branches and the same forms.
}  // namespace cageproof::closed_form
template <>
inline constexpr bool cageproof::stands_for_double<cageproof::closed_form::Counted> = true;

namespace cageproof::closed_form {

/// An operand: a counted number, or an exact one. Converting to it notes the source line of the operation.
struct Operand {
  double value;
  const Mp200* shadow = nullptr;  ///< null: the value is exact
  std::uint32_t node = 0;
  std::source_location where;

  Operand(const Counted& x, std::source_location at = std::source_location::current());
  Operand(int x, std::source_location at = std::source_location::current()) : value(x), where(at) {}
  Operand(double x, std::source_location at = std::source_location::current()) : value(x), where(at) {}
};

/// `value` is what double computes, bit for bit; comparisons, and with them branches, are double's. `shadow` is what
/// the same operations give in 200 digits. Operations are recorded on the thread's CountedTape, where there is one.
///
/// Compensated arithmetic must not be run in this type: the error term of a two-sum is small because it is meant to be,
/// and would be reported as a cancellation. Take its outcome as one number, with `seen`.
class Counted {
 public:
  double value = 0;
  Mp200 shadow;
  std::uint32_t node = 0;  ///< its place on the tape; 0: none, an exact number or one from before the recording

  Counted() = default;
  /// Exact numbers.
  Counted(int x) : value(x), shadow(x) {}
  Counted(double x) : value(x), shadow(x) {}
  Counted(double v, const Mp200& exact, std::uint32_t place = 0) : value(v), shadow(exact), node(place) {}
  /// A number that arithmetic of another kind computed, as one operation. \param name a string that outlives the tape
  static Counted seen(double value, const Mp200& exact, const char* name, const char* file);

  explicit operator double() const { return value; }

  friend Counted operator-(const Counted& a);
  friend Counted operator+(const Operand& a, const Operand& b);
  friend Counted operator-(const Operand& a, const Operand& b);
  friend Counted operator*(const Operand& a, const Operand& b);
  friend Counted operator/(const Operand& a, const Operand& b);
  friend Counted& operator+=(Counted& a, const Operand& b);
  friend Counted& operator-=(Counted& a, const Operand& b);
  friend Counted& operator*=(Counted& a, const Operand& b);
  friend Counted& operator/=(Counted& a, const Operand& b);

  friend bool operator==(const Counted& a, const Counted& b) { return a.value == b.value; }
  friend bool operator<(const Counted& a, const Counted& b) { return a.value < b.value; }
  friend bool operator>(const Counted& a, const Counted& b) { return a.value > b.value; }
  friend bool operator<=(const Counted& a, const Counted& b) { return a.value <= b.value; }
  friend bool operator>=(const Counted& a, const Counted& b) { return a.value >= b.value; }

  friend Counted abs(const Counted& a) { return std::signbit(a.value) ? -a : a; }
  friend Counted sqrt(const Operand& a);
  friend Counted log(const Operand& a);
  friend Counted log1p(const Operand& a);
  friend Counted exp(const Operand& a);
  friend Counted atan(const Operand& a);
  friend Counted atanh(const Operand& a);
  friend Counted atan2(const Operand& y, const Operand& x);
  /// x 2^exponent, which is exact unless it underflows.
  friend Counted ldexp(const Counted& x, int exponent);
  /// frexp of the value in double.
  friend double frexp(const Counted& x, int* exponent) { return std::frexp(x.value, exponent); }
  friend bool isfinite(const Counted& x) { return std::isfinite(x.value); }
};

inline Operand::Operand(const Counted& x, std::source_location at)
    : value(x.value), shadow(&x.shadow), node(x.node), where(at) {}

/// While it lives, operations within a helper (a polynomial's) count for the line that called it.
class AttributedTo {
 public:
  AttributedTo(const char* helper, const std::source_location& caller);
  /// For helpers that do not know their caller, such as Eigen's: the line of the last operation that stands in the
  /// open, which is at or before the caller's.
  explicit AttributedTo(const char* helper);
  ~AttributedTo();
  AttributedTo(const AttributedTo&) = delete;
  AttributedTo& operator=(const AttributedTo&) = delete;

 private:
  bool outermost_;
};

/// Polynomials whose operations count for the line of the closed form that asks for them.
template <int N>
struct Taylor<Counted, N> : Polynomial<Counted, N> {
  using Plain = Polynomial<Counted, N>;
  using Where = std::source_location;
  /// An operator's argument with the operator's source line.
  template <class T>
  struct From {
    const T& it;
    Where at;
    From(const T& x, const Where& where = Where::current()) : it(x), at(where) {}
  };

  Taylor& operator+=(const From<Taylor>& other) {
    const AttributedTo line("+=", other.at);
    Plain::operator+=(other.it);
    return *this;
  }
  Taylor& operator*=(const From<Counted>& factor) {
    const AttributedTo line("*=", factor.at);
    Plain::operator*=(factor.it);
    return *this;
  }
  template <int F>
  void add(const Counted& factor, const Taylor<Counted, F>& f, const Where& at = Where::current()) {
    const AttributedTo line("add", at);
    Plain::add(factor, f);
  }
  template <class V, int F>
  void add_raised(int k, const V& v, const Taylor<Counted, F>& f, const Where& at = Where::current()) {
    const AttributedTo line("add_raised", at);
    Plain::add_raised(k, v, f);
  }
  void divide_part(int k, const Counted& divisor, const Where& at = Where::current()) {
    const AttributedTo line("divide_part", at);
    Plain::divide_part(k, divisor);
  }
  template <class V, int F>
  void add_linear(const Counted& constant, const V& v, const Taylor<Counted, F>& f,
                  const Where& at = Where::current()) {
    const AttributedTo line("add_linear", at);
    Plain::add_linear(constant, v, f);
  }
};

}  // namespace cageproof::closed_form

template <>
class std::numeric_limits<cageproof::closed_form::Counted> : public std::numeric_limits<double> {};

template <>
struct Eigen::NumTraits<cageproof::closed_form::Counted> : Eigen::GenericNumTraits<cageproof::closed_form::Counted> {
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

/// Eigen sums products in double from the first on, but in other types pairwise.
template <>
struct Eigen::internal::dot_nocheck<cageproof::Vec3<cageproof::closed_form::Counted>,
                                    cageproof::Vec3<cageproof::closed_form::Counted>, false> {
  using Vector = Eigen::MatrixBase<cageproof::Vec3<cageproof::closed_form::Counted>>;
  static cageproof::closed_form::Counted run(const Vector& a, const Vector& b) {
    const cageproof::closed_form::AttributedTo line("Eigen");
    return a.coeff(0) * b.coeff(0) + a.coeff(1) * b.coeff(1) + a.coeff(2) * b.coeff(2);
  }
};

/// Constants are rounded once, which is recorded.
template <>
cageproof::closed_form::Counted cageproof::pi<cageproof::closed_form::Counted>();
template <>
cageproof::closed_form::Counted cageproof::ln_two<cageproof::closed_form::Counted>();
