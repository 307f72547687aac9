// SPDX-License-Identifier: MIT
// Integrals along a line of a quad, as formulas: int_0^1 (1-u)^i u^j r^(-q) du for odd q, r^2 = (1-u)^2 a^2 + 2u(1-u) g
// + u^2 b^2, as sums of products of a, b, w = ab + g, S = a + b and the functions G of line_functions.h. All are
// analytic wherever the line does not pass the point between its ends: no division by the line's length, nor by the
// distance of the line from the point.
#pragma once

#include <array>
#include <compare>
#include <vector>

namespace cageproof::quadrature_ref::certified {

/// a^powers[0] b^powers[1] w^powers[2] S^powers[3], times G(function, derivative) where function is not negative.
struct LineProduct {
  std::array<int, 4> powers{};
  int function = -1;
  int derivative = 0;
  friend auto operator<=>(const LineProduct&, const LineProduct&) = default;
};

/// The sum of factor * product, over `denominator`.
struct LineFormula {
  struct Term {
    LineProduct product;
    long factor;
  };
  std::vector<Term> terms;
  long denominator = 1;
};

/// How far i + j may be above q.
inline constexpr int kLeastExcess = -2, kMostExcess = 2;

/// \pre q odd, q >= -1, kLeastExcess <= i + j - q <= kMostExcess, i + j >= 0
LineFormula line_formula(int i, int j, int q);

}  // namespace cageproof::quadrature_ref::certified
