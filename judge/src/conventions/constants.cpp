// SPDX-License-Identifier: MIT
// Constants that people put before integrals, recognised.
#include "cageproof/judge/convention.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

namespace cageproof::judge {
namespace {

// "4 pi", "pi^2", "3", or empty for one.
std::string product(int number, int pi_power) {
  std::string text = number == 1 && pi_power > 0 ? "" : fmt::format("{}", number);
  if (pi_power > 0) text += (text.empty() ? "" : " ") + std::string(pi_power == 1 ? "pi" : "pi^2");
  return text;
}

std::string fraction(bool negative, const std::array<int, 2>& numbers, int pi_power) {
  const std::string above = product(numbers[0], std::max(pi_power, 0));
  const std::string below = product(numbers[1], std::max(-pi_power, 0));
  const std::string sign = negative ? "-" : "";
  if (below == "1") return sign + above;
  return sign + above + "/" + (below.find(' ') != std::string::npos ? "(" + below + ")" : below);
}

}  // namespace

std::string name_of_constant(double x, double within) {
  for (const int pi_power : {0, -1, 1, -2, 2})
    for (const int three : {0, -1, 1})
      for (int two = -6; two <= 6; ++two) {
        const double y = std::ldexp(std::pow(3.0, three) * std::pow(std::numbers::pi, pi_power), two);
        if (std::abs(std::abs(x) - y) > within * y) continue;
        std::array<int, 2> numbers{1, 1};
        numbers[two < 0 ? 1 : 0] <<= std::abs(two);
        if (three != 0) numbers[three < 0 ? 1 : 0] *= 3;
        return fraction(x < 0, numbers, pi_power);
      }
  return {};
}

}  // namespace cageproof::judge
