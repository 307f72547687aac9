// SPDX-License-Identifier: MIT
// Exponents of clamped corners.
#include "../src/goursat/corner_exponents.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace cageproof::solved::goursat {
namespace {

constexpr double kPi = std::numbers::pi;
using Number = std::complex<double>;

// Zeros by mpmath, 17 digits.
TEST(clamped_exponents, are_the_known_ones) {
  const auto expect_first = [](double angle, const std::vector<std::pair<Number, bool>>& expected) {
    const auto found = clamped_exponents(angle, 20);
    ASSERT_GE(found.size(), expected.size());
    for (std::size_t i = 0; i < expected.size(); ++i) {
      EXPECT_LE(std::abs(found[i].mu - expected[i].first), 1e-13) << angle << ' ' << found[i].mu;
      EXPECT_EQ(found[i].odd, expected[i].second);
    }
  };
  expect_first(kPi / 2,
               {{{2.7395933563245961, 1.1190245343424165}, false}, {{4.8082507612742243, 1.4639281216983371}, true}});
  expect_first(
      1.5 * kPi,
      {{0.54448373678246393, false}, {0.90852918984609882, true}, {{1.6292573767595702, 0.23125054711510754}, false}});
  expect_first(kPi / 3, {{{4.0593290121513715, 1.9520499472275047}, false}});
  expect_first(1.75 * kPi, {{0.50500969889658942, false}});
}

// The number of zeros in a rectangle, from how often the function winds around zero along its border.
int zeros_within(double angle, bool odd, double left, double right, double height) {
  const auto f = [&](const Number& mu) {
    const double s = odd ? -1 : 1;
    return (std::sin(mu * angle) + s * mu * std::sin(angle)) / (odd ? mu * (mu - 1.0) : mu);
  };
  const std::array corners{Number(left, -height), Number(right, -height), Number(right, height), Number(left, height)};
  constexpr int steps = 20000;
  double turned = 0;
  for (int side = 0; side < 4; ++side)
    for (int i = 0; i < steps; ++i) {
      const Number a = corners[side], e = corners[(side + 1) % 4] - a;
      turned += std::arg(f(a + e * ((i + 1.0) / steps)) / f(a + e * (i / double(steps))));
    }
  return static_cast<int>(std::lround(turned / (2 * kPi)));
}

TEST(clamped_exponents, are_all) {
  for (const double angle : {0.1, 0.5, 1.0, kPi / 2, 2.0, 2.5, 2.6, 3.0, 3.3, 4.0, 1.5 * kPi, 5.0, 6.0, 6.28})
    for (const bool odd : {false, true}) {
      const double largest = 8.3 * kPi / angle;
      int found = 0;
      for (const CornerExponent& e : clamped_exponents(angle, largest))
        if (e.odd == odd) found += e.is_real() ? 1 : 2;
      EXPECT_EQ(found, zeros_within(angle, odd, 0.01, largest, 10 / angle)) << angle << ' ' << odd;
    }
}

TEST(clamped_exponents, functions_vanish_on_both_sides_with_their_slopes) {
  for (const double angle : {0.1, 1.0, kPi / 2, 2.5, 3.0, 4.0, 1.5 * kPi, 6.0, 2 * kPi})
    for (const CornerExponent& e : clamped_exponents(angle, 10 * kPi / angle)) {
      const Number a = (e.mu + 1.0) * angle / 2.0, b = (e.mu - 1.0) * angle / 2.0;
      const Number value =
          e.odd ? e.outer * std::sin(a) + e.inner * std::sin(b) : e.outer * std::cos(a) + e.inner * std::cos(b);
      const Number slope = e.odd ? e.outer * (e.mu + 1.0) * std::cos(a) + e.inner * (e.mu - 1.0) * std::cos(b)
                                 : -e.outer * (e.mu + 1.0) * std::sin(a) - e.inner * (e.mu - 1.0) * std::sin(b);
      const double size = std::abs(std::cosh(std::abs(a.imag()))) * std::abs(e.mu + 1.0);
      EXPECT_LE(std::abs(value), 1e-12 * size) << angle << ' ' << e.mu;
      EXPECT_LE(std::abs(slope), 1e-12 * size) << angle << ' ' << e.mu;
      EXPECT_NEAR(std::hypot(std::abs(e.outer), std::abs(e.inner)), 1, 1e-12);
    }
}

}  // namespace
}  // namespace cageproof::solved::goursat
