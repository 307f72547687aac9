// SPDX-License-Identifier: MIT
// Running error bounds must hold, and the arithmetic in pairs must have its digits.
#include "cageproof/closed_form/arithmetic/tracked.h"
#include "cageproof/core/numbers/random_stream.h"

#include <gtest/gtest.h>

namespace cageproof::closed_form::tracked_test {
namespace {

// One expression after another with cancellation in between, in any arithmetic.
template <class T>
std::array<T, 6> expressions(double x, double y, double z) {
  using std::abs, std::atan2, std::atanh, std::log, std::sqrt;
  const T a(x), b(y), c(z);
  const T s = sqrt(a * a + b * b + c * c);
  return {s - a,
          (s - abs(a)) / (s + a + T(3)),
          log(s / (s + c * c)) + c * c / s,
          atan2(b * (s - a), a + c),
          atanh(a / (s + T(1))) - a / (s + T(1)),
          (a + b) * (a - b) - a * a + b * b};
}

template <class T>
void expect_bounds_hold(const char* name) {
  for (int i = 0; i < 2000; ++i) {
    RandomStream random(31, name, i);
    const double x = random.uniform(0.1, 1), y = random.uniform(-1, 1) * std::exp2(-random.below(30)),
                 z = random.uniform(-1, 1) * std::exp2(-random.below(30));
    const auto found = expressions<Tracked<T>>(x, y, z);
    const auto exact = expressions<Mp200>(x, y, z);
    for (std::size_t k = 0; k < found.size(); ++k) {
      Mp200 value;
      if constexpr (std::same_as<T, DoubleDouble>) value = Mp200(found[k].value.high) + found[k].value.low;
      else value = Mp200(found[k].value);
      const Mp200 error = abs(value - exact[k]);
      EXPECT_TRUE(error <= Mp200(roundoff_of<T>()) * Mp200(found[k].error) * Mp200(1.001))
          << "expression " << k << ", sample " << i;
    }
  }
}

TEST(tracked, bounds_hold_in_double) { expect_bounds_hold<double>("double"); }
TEST(tracked, bounds_hold_in_pairs) { expect_bounds_hold<DoubleDouble>("pairs"); }

// Numbers as far off as their bounds allow, in both directions, through one operation each.
TEST(tracked, every_operation_passes_on_the_errors_of_its_operands) {
  constexpr double u = 0x1p-53;
  const auto exact = [](const Tracked<double>& x, int sign) {
    return Mp100(x.value) + Mp100(sign * u) * Mp100(x.error);
  };
  for (int i = 0; i < 500; ++i) {
    RandomStream random(33, "operations", i);
    // Now and then exact operands, so that the operation's own rounding is all there is.
    const double size = i % 3 == 0 ? 0 : std::exp2(random.below(30));
    const Tracked<double> a(random.uniform(0.2, 0.9), size * random.uniform()),
        b(random.uniform(0.2, 0.9), size * random.uniform());
    for (const int s : {-1, 1})
      for (const int t : {-1, 1}) {
        const Mp100 x = exact(a, s), y = exact(b, t);
        const auto expect_within = [&](const Tracked<double>& found, const Mp100& truth) {
          EXPECT_TRUE(abs(Mp100(found.value) - truth) <= Mp100(u) * Mp100(found.error) * Mp100(1 + 1e-6))
              << "sample " << i;
        };
        expect_within(a + b, x + y);
        expect_within(a - b, x - y);
        expect_within(a * b, x * y);
        expect_within(a / b, x / y);
        expect_within(sqrt(a), sqrt(x));
        expect_within(log(a), log(x));
        expect_within(atanh(a), atanh(x));
        expect_within(atan2(a, b), atan2(x, y));
      }
  }
}

TEST(tracked, nothing_is_certain_after_total_cancellation) {
  const Tracked<double> a(1.0 / 3, 1.0 / 3), b = a * Tracked<double>(3) - Tracked<double>(1);
  EXPECT_GE(b.error * roundoff_of<double>(), b.magnitude());
  EXPECT_FALSE(std::isfinite((Tracked<double>(1) / b).error));
}

TEST(double_double, quotients_and_roots_keep_a_hundred_bits) {
  for (int i = 0; i < 1000; ++i) {
    RandomStream random(32, "pairs", i);
    const DoubleDouble a(random.uniform(0.5, 1), random.uniform(-1, 1) * 0x1p-55),
        b(random.uniform(0.5, 1), random.uniform(-1, 1) * 0x1p-55);
    const auto wide = [](const DoubleDouble& x) { return Mp100(x.high) + x.low; };
    EXPECT_TRUE(abs(wide(a / b) - wide(a) / wide(b)) <= Mp100(0x1p-100));
    EXPECT_TRUE(abs(wide(sqrt(a)) - Mp100(sqrt(wide(a)))) <= Mp100(0x1p-100));
    EXPECT_TRUE(abs(wide(log(a)) - Mp100(log(wide(a)))) <= Mp100(0x1p-102));
  }
}

}  // namespace
}  // namespace cageproof::closed_form::tracked_test
