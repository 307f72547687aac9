// SPDX-License-Identifier: MIT
#include "cageproof/closed_form/arithmetic/counted.h"

#include "cageproof/closed_form/arithmetic/counted_tape.h"

#include <algorithm>
#include <cmath>

namespace cageproof::closed_form {

// u of double: the unit of relative errors.
static constexpr double kUnit = 0x1p-53;

/// Puts one operation on the thread's tape.
struct Recorder {
  /// Facts about an operation, in addition to its operands.
  struct Done {
    double value;
    Mp200 shadow;
    std::array<double, 2> slope;
    double rounding;             // value less the exact outcome of the operation on the operands' values
    bool errors_add_up = false;  // relative errors of operands add up, as in products
  };

  static Counted record(const char* name, const Operand& a, const Operand* b, const Done& done) {
    Counted result(done.value, done.shadow);
    CountedTape* const tape = CountedTape::current();
    if (tape == nullptr) return result;
    CountedTape::Node node;
    const CountedTape::Site site = tape->site_of((b != nullptr ? *b : a).where, name);
    node.site = tape->site(site);
    node.from[0] = place(*tape, a, site);
    if (b != nullptr) node.from[1] = place(*tape, *b, site);
    node.slope = done.slope;
    node.rounding = std::isfinite(done.rounding) ? done.rounding : 0;
    const double first = relative_error(a), second = b != nullptr ? relative_error(*b) : 0;
    node.before = std::max(first, second);
    const double error = std::abs(static_cast<double>(Mp200(done.value) - done.shadow));
    node.after = done.value == 0 && error == 0 ? 0 : error / std::abs(done.value) / kUnit;
    const double granted = ((done.errors_add_up ? first + second : node.before) + 1) * kUnit * std::abs(done.value);
    node.lost = error > granted ? error - granted : 0;
    if (b != nullptr && !done.errors_add_up) node.bits = cancelled(a.value, b->value, done.value);
    if (name == kAngle) node.bits = 0;
    result.node = push(*tape, node);
    return result;
  }

  /// A number of its own that is wrong by `error`, and the operation that it stands for.
  static std::uint32_t leaf(CountedTape& tape, double value, const Mp200& shadow, const CountedTape::Site& site) {
    CountedTape::Node node;
    node.site = tape.site(site);
    node.rounding = static_cast<double>(Mp200(value) - shadow);
    if (!std::isfinite(node.rounding)) node.rounding = 0;
    node.after = std::abs(node.rounding / value) / kUnit;
    node.lost = std::max(0., std::abs(node.rounding) - kUnit * std::abs(value));
    return push(tape, node);
  }

  static constexpr const char* kAngle = "atan2";

 private:
  static std::uint32_t push(CountedTape& tape, const CountedTape::Node& node) {
    tape.nodes_.push_back(node);
    return static_cast<std::uint32_t>(tape.nodes_.size());
  }
  // Numbers that were made before the recording, and are rounded, get their place at their first use.
  static std::uint32_t place(CountedTape& tape, const Operand& x, CountedTape::Site site) {
    if (x.node != 0 || x.shadow == nullptr || Mp200(x.value) == *x.shadow) return x.node;
    site.operation = "constant";
    return leaf(tape, x.value, *x.shadow, site);
  }
  // A number's relative error in units of 2^-53; zero for exact numbers, infinite for a zero that should be none.
  static double relative_error(const Operand& x) {
    if (x.shadow == nullptr || Mp200(x.value) == *x.shadow) return 0;
    return std::abs(static_cast<double>(Mp200(Mp200(x.value) - *x.shadow)) / x.value) / kUnit;
  }
  static std::int16_t cancelled(double a, double b, double sum) {
    constexpr int kAll = 53;
    const double larger = std::max(std::abs(a), std::abs(b));
    if (larger == 0 || !std::isfinite(larger) || !std::isfinite(sum)) return 0;
    if (sum == 0) return kAll;
    return static_cast<std::int16_t>(std::clamp(std::ilogb(larger) - std::ilogb(sum), 0, kAll));
  }
};

namespace {

Mp200 exact(const Operand& x) { return x.shadow != nullptr ? *x.shadow : Mp200(x.value); }

// The result of a function of one operand. \param slope its derivative
template <class F>
Counted function(const char* name, const Operand& a, double value, double slope, const F& f) {
  return Recorder::record(
      name, a, nullptr, {value, f(exact(a)), {slope, 0}, static_cast<double>(Mp200(Mp200(value) - f(Mp200(a.value))))});
}

// a + b, b with its sign. The rounding is Knuth's.
double rounding_of_sum(double a, double b, double sum) {
  const double t = sum - a;
  return -((a - (sum - t)) + (b - t));
}

// The operand as a number: exact, or the counted one's own node.
Operand operand_of(const Counted& x, const std::source_location& where) { return {x, where}; }

}  // namespace

Counted Counted::seen(double value, const Mp200& exact, const char* name, const char* file) {
  Counted x(value, exact);
  if (CountedTape* const tape = CountedTape::current(); tape != nullptr && !(Mp200(value) == exact))
    x.node = Recorder::leaf(*tape, value, exact, {file, 0, name, nullptr});
  return x;
}

Counted operator-(const Counted& a) {
  static const char* const name = "-";
  if (a.node == 0) return {-a.value, -a.shadow};
  return Recorder::record(name, Operand(a), nullptr, {-a.value, -a.shadow, {-1, 0}, 0});
}
Counted operator+(const Operand& a, const Operand& b) {
  const double sum = a.value + b.value;
  return Recorder::record("+", a, &b, {sum, exact(a) + exact(b), {1, 1}, rounding_of_sum(a.value, b.value, sum)});
}
Counted operator-(const Operand& a, const Operand& b) {
  const double sum = a.value - b.value;
  return Recorder::record("-", a, &b, {sum, exact(a) - exact(b), {1, -1}, rounding_of_sum(a.value, -b.value, sum)});
}
Counted operator*(const Operand& a, const Operand& b) {
  const double product = a.value * b.value;
  return Recorder::record(
      "*", a, &b, {product, exact(a) * exact(b), {b.value, a.value}, -std::fma(a.value, b.value, -product), true});
}
Counted operator/(const Operand& a, const Operand& b) {
  const double quotient = a.value / b.value;
  return Recorder::record("/", a, &b,
                          {quotient,
                           exact(a) / exact(b),
                           {1 / b.value, -quotient / b.value},
                           -std::fma(-quotient, b.value, a.value) / b.value,
                           true});
}
Counted& operator+=(Counted& a, const Operand& b) { return a = operand_of(a, b.where) + b; }
Counted& operator-=(Counted& a, const Operand& b) { return a = operand_of(a, b.where) - b; }
Counted& operator*=(Counted& a, const Operand& b) { return a = operand_of(a, b.where) * b; }
Counted& operator/=(Counted& a, const Operand& b) { return a = operand_of(a, b.where) / b; }

Counted sqrt(const Operand& a) {
  const double root = std::sqrt(a.value);
  return function("sqrt", a, root, 0.5 / root, [](const Mp200& x) { return sqrt(x); });
}
Counted log(const Operand& a) {
  return function("log", a, std::log(a.value), 1 / a.value, [](const Mp200& x) { return log(x); });
}
Counted log1p(const Operand& a) {
  return function("log1p", a, std::log1p(a.value), 1 / (1 + a.value), [](const Mp200& x) { return log1p(x); });
}
Counted exp(const Operand& a) {
  const double power = std::exp(a.value);
  return function("exp", a, power, power, [](const Mp200& x) { return exp(x); });
}
Counted atan(const Operand& a) {
  return function("atan", a, std::atan(a.value), 1 / (1 + a.value * a.value), [](const Mp200& x) { return atan(x); });
}
Counted atanh(const Operand& a) {
  return function("atanh", a, std::atanh(a.value), 1 / ((1 - a.value) * (1 + a.value)),
                  [](const Mp200& x) { return atanh(x); });
}
Counted atan2(const Operand& y, const Operand& x) {
  const double angle = std::atan2(y.value, x.value), reach = std::hypot(x.value, y.value);
  return Recorder::record(Recorder::kAngle, y, &x,
                          {angle,
                           atan2(exact(y), exact(x)),
                           {x.value / reach / reach, -(y.value / reach / reach)},
                           static_cast<double>(Mp200(Mp200(angle) - atan2(Mp200(y.value), Mp200(x.value))))});
}
Counted ldexp(const Counted& x, int exponent) {
  const double scale = std::ldexp(1., exponent);
  return Recorder::record("ldexp", Operand(x), nullptr,
                          {std::ldexp(x.value, exponent), ldexp(x.shadow, exponent), {scale, 0}, 0});
}

}  // namespace cageproof::closed_form

template <>
cageproof::closed_form::Counted cageproof::pi<cageproof::closed_form::Counted>() {
  return closed_form::Counted::seen(pi<double>(), pi<Mp200>(), "pi",
                                    "core/include/cageproof/core/numbers/scalar_names.h");
}

template <>
cageproof::closed_form::Counted cageproof::ln_two<cageproof::closed_form::Counted>() {
  return closed_form::Counted::seen(ln_two<double>(), ln_two<Mp200>(), "ln 2",
                                    "core/include/cageproof/core/numbers/scalar_names.h");
}
