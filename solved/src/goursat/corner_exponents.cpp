// SPDX-License-Identifier: MIT
#include "corner_exponents.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

namespace cageproof::solved::goursat {
namespace {

using Number = std::complex<double>;

// Newton's method on sin(mu angle) -+ mu sin(angle), divided by its zeros that are no exponents: 0, and of odd ones -1
// and 1.
std::optional<Number> zero_near(Number mu, double angle, bool odd) {
  const double sign = odd ? -1 : 1;
  for (int step = 0; step < 60; ++step) {
    const Number f = std::sin(mu * angle) + sign * mu * std::sin(angle);
    const Number slope = angle * std::cos(mu * angle) + sign * std::sin(angle);
    Number known = 1.0 / mu;
    if (odd) known += 1.0 / (mu - 1.0) + 1.0 / (mu + 1.0);
    const Number change = f / (slope - f * known);
    mu -= change;
    if (!(std::abs(mu) < 1e4)) return std::nullopt;
    if (std::abs(change) <= 1e-15 * std::abs(mu)) return mu;
  }
  return std::nullopt;
}

// How much of both terms makes value and derivative vanish on the sides: the null vector of a 2 x 2 matrix, from its
// larger row. At 2 pi the row of values vanishes.
CornerExponent with_parts(Number mu, double angle, bool odd) {
  const Number outer = (mu + 1.0) * angle / 2.0, inner = (mu - 1.0) * angle / 2.0;
  const Number outer_value = odd ? std::sin(outer) : std::cos(outer),
               inner_value = odd ? std::sin(inner) : std::cos(inner);
  const Number outer_slope = (mu + 1.0) * (odd ? std::cos(outer) : -std::sin(outer));
  const Number inner_slope = (mu - 1.0) * (odd ? std::cos(inner) : -std::sin(inner));
  const bool by_values = std::abs(mu) * (std::abs(outer_value) + std::abs(inner_value)) >
                         1e-3 * (std::abs(outer_slope) + std::abs(inner_slope));
  CornerExponent found{mu, odd, by_values ? inner_value : inner_slope, by_values ? -outer_value : -outer_slope};
  const double length = std::hypot(std::abs(found.outer), std::abs(found.inner));
  found.outer /= length;
  found.inner /= length;
  return found;
}

}  // namespace

std::vector<CornerExponent> clamped_exponents(double angle, double largest) {
  std::vector<CornerExponent> found;
  for (const bool odd : {false, true}) {
    std::vector<Number> zeros;
    // Zeros lie about pi/angle apart, and their imaginary parts, times the angle, grow as the logarithm of the real
    // ones.
    const double unit = 1 / angle;
    for (double x = 0.3 * unit; x < largest + 3 * unit; x += 0.6 * unit)
      for (const double y : {0.0, 0.5, 1.0, 1.5, 2.0, 3.0, 4.0, 5.0}) {
        auto zero = zero_near({x, y * unit}, angle, odd);
        if (!zero || zero->real() < 1e-3 || zero->real() >= largest) continue;
        if (zero->imag() < 0) zero = std::conj(*zero);
        if (zero->imag() < 1e-9 * std::abs(*zero)) zero = zero->real();
        if (odd && std::abs(*zero - 1.0) < 1e-7) continue;
        const auto same = [&](const Number& z) { return std::abs(z - *zero) < 1e-7 * std::abs(z); };
        if (std::ranges::none_of(zeros, same)) zeros.push_back(*zero);
      }
    for (const Number& mu : zeros) found.push_back(with_parts(mu, angle, odd));
  }
  std::ranges::sort(found, [](const CornerExponent& a, const CornerExponent& b) {
    return std::pair(a.mu.real(), a.odd) < std::pair(b.mu.real(), b.odd);
  });
  return found;
}

}  // namespace cageproof::solved::goursat
