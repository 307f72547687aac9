// SPDX-License-Identifier: MIT
// Integrals along a line of a quad, as formulas: int_0^1 (1-u)^i u^j r^(-q) du, r^2 = (1-u)^2 a^2 + 2u(1-u) g + u^2
// b^2, as sums of products of a, b, w = ab + g, S = a + b, g and the functions of line_functions.h: G where q is odd,
// the angle's where it is even. None divides by the line's length, nor by the distance of the line from the point.
#pragma once

#include <array>
#include <compare>
#include <vector>

namespace cageproof::quadrature_ref::certified {

inline constexpr int kLineSymbols = 5;

/// Powers of a, b, w, S, g, times the function's derivative where function is not negative.
struct LineProduct {
  std::array<int, kLineSymbols> powers{};
  int function = -1;
  int derivative = 0;
  friend auto operator<=>(const LineProduct&, const LineProduct&) = default;
};

/// The sum of factor * product, over `denominator`.
struct LineFormula {
  struct Term {
    LineProduct product;
    int factor;
  };
  std::vector<Term> terms;
  long denominator = 1;
};

/// How far i + j may be above q where q is odd; where it is even, it is two below.
inline constexpr int kLeastExcess = -2, kMostExcess = 2;

/// \throws std::logic_error where q < -1 is odd or q < 2 even, and for an i + j that is not allowed
LineFormula line_formula(int i, int j, int q);

}  // namespace cageproof::quadrature_ref::certified
