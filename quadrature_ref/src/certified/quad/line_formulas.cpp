// SPDX-License-Identifier: MIT
#include "line_formulas.h"

#include <map>
#include <numeric>
#include <stdexcept>
#include <utility>

namespace cageproof::quadrature_ref::certified {
namespace {

enum Symbol { A, B, W, S, G };

struct Fraction {
  long top = 0, bottom = 1;
};
Fraction operator*(const Fraction& x, const Fraction& y) {
  const long p = x.top * y.top, q = x.bottom * y.bottom, common = std::gcd(p, q);
  return {p / common, q / common};
}
Fraction operator+(const Fraction& x, const Fraction& y) {
  const long p = x.top * y.bottom + y.top * x.bottom, q = x.bottom * y.bottom, common = std::gcd(p, q);
  return {p / common, q / common};
}

using LineSum = std::map<LineProduct, Fraction>;

void add_to(LineSum& sum, const LineProduct& product, const Fraction& factor) {
  Fraction& at = sum[product];
  at = at + factor;
  if (at.top == 0) sum.erase(product);
}

LineProduct times(LineProduct product, Symbol symbol, int power) {
  product.powers[symbol] += power;
  return product;
}
LineProduct function(int number) { return {{}, number, 0}; }

LineSum operator*(const Fraction& factor, const LineSum& sum) {
  LineSum scaled;
  for (const auto& [product, f] : sum) add_to(scaled, product, factor * f);
  return scaled;
}
LineSum operator+(LineSum sum, const LineSum& other) {
  for (const auto& [product, f] : other) add_to(sum, product, f);
  return sum;
}
// By polynomials in a and b, which hold no function.
LineSum operator*(const LineSum& polynomial, const LineSum& sum) {
  LineSum all;
  for (const auto& [p, f] : polynomial)
    for (const auto& [product, h] : sum) {
      LineProduct both = product;
      for (int i = 0; i < kLineSymbols; ++i) both.powers[i] += p.powers[i];
      add_to(all, both, f * h);
    }
  return all;
}

// The derivative of G by S, as S and w, less the factor: -j! S^(-2m)/(2w)^(j+1).
LineProduct without_function(const LineProduct& product) {
  LineProduct rest = product;
  rest.powers[S] -= 2 * product.function;
  rest.powers[W] -= product.derivative + 1;
  rest.function = -1;
  rest.derivative = 0;
  return rest;
}
Fraction of_rest(const LineProduct& product) {
  Fraction f{-1, 2};
  for (int i = 1; i <= product.derivative; ++i) f = f * Fraction{i, 2};
  return f;
}

// (1/a) d/da, with b and g fixed: twice the derivative by a^2; or the same with b for a.
LineSum by_square(const LineSum& sum, Symbol end) {
  const Symbol other = end == A ? B : A;
  LineSum derivative;
  for (const auto& [product, f] : sum) {
    const auto& p = product.powers;
    add_to(derivative, times(product, end, -2), f * Fraction{p[end]});
    add_to(derivative, times(times(product, S, -1), end, -1), f * Fraction{p[S]});
    add_to(derivative, times(times(times(product, W, -1), other, 1), end, -1), f * Fraction{p[W]});
    if (product.function < 0) continue;
    LineProduct steeper = product;
    ++steeper.derivative;
    add_to(derivative, steeper, f * Fraction{2});
    add_to(derivative, times(without_function(product), end, -1), f * of_rest(product));
  }
  return derivative;
}

// d/dg, with a and b fixed.
LineSum by_product(const LineSum& sum) {
  LineSum derivative;
  for (const auto& [product, f] : sum) {
    add_to(derivative, times(product, W, -1), f * Fraction{product.powers[W]});
    if (product.function < 0) continue;
    LineProduct steeper = product;
    ++steeper.derivative;
    add_to(derivative, steeper, f * Fraction{-2});
  }
  return derivative;
}

// int r du = S/4 + w G_0/2 + (b-a)^2 (G_0 - S^2 G_1)/4.
LineSum mean_distance() {
  LineSum square, sum, bracket;
  add_to(square, {{2, 0, 0, 0}}, {1});
  add_to(square, {{0, 2, 0, 0}}, {1});
  add_to(square, {{1, 1, 0, 0}}, {-2});
  add_to(sum, {{0, 0, 0, 1}}, {1, 4});
  add_to(sum, times(function(0), W, 1), {1, 2});
  add_to(bracket, function(0), {1, 4});
  add_to(bracket, times(function(1), S, 2), {-1, 4});
  return sum + square * bracket;
}

// The integrals that all others are derivatives of (../README.md).
LineSum base(int i, int j, int q) {
  LineSum sum;
  if (q == 3) {
    add_to(sum, times(times({}, W, -1), i == 1 ? A : B, -1), {1});
    return sum;
  }
  if (q == 1 && i + j == 0) {
    add_to(sum, function(0), {2});
    return sum;
  }
  LineSum difference;  // of the end that the weight is largest at, and the other
  add_to(difference, times({}, j == 1 ? B : A, 1), {1});
  add_to(difference, times({}, j == 1 ? A : B, 1), {-1});
  if (q == 1) {
    add_to(sum, times(function(1), S, 1), {-1});
    sum = difference * sum;
    add_to(sum, function(0), {1});
    return sum;
  }
  if (i + j == 0) return mean_distance();
  LineSum first, cubic;
  add_to(first, times(function(0), S, 1), {1, 8});
  add_to(first, times(function(1), S, 3), {-1, 8});
  add_to(cubic, times(function(1), S, 1), {-1, 8});
  add_to(cubic, times(function(2), S, 3), {1, 8});
  return Fraction{1, 2} * mean_distance() + difference * (first + difference * (difference * cubic));
}

// The angle's function of D = a^2 b^2 - g^2 and g: by a^2 and b^2, as by_square, and by g, where its own derivative is
// -(-1)^j j! (ab)^(-2(j+1)).
LineSum angle_by_square(const LineSum& sum, Symbol end) {
  LineSum derivative;
  for (const auto& [product, f] : sum) {
    add_to(derivative, times(product, end, -2), f * Fraction{product.powers[end]});
    if (product.function < 0) continue;
    LineProduct steeper = times(product, end == A ? B : A, 2);
    ++steeper.derivative;
    add_to(derivative, steeper, f * Fraction{2});
  }
  return derivative;
}
LineSum angle_by_product(const LineSum& sum) {
  LineSum derivative;
  for (const auto& [product, f] : sum) {
    add_to(derivative, times(product, G, -1), f * Fraction{product.powers[G]});
    if (product.function < 0) continue;
    LineProduct steeper = times(product, G, 1);
    ++steeper.derivative;
    add_to(derivative, steeper, f * Fraction{-2});
    LineProduct rest = times(times(product, A, -2 * (product.derivative + 1)), B, -2 * (product.derivative + 1));
    rest.function = -1;
    rest.derivative = 0;
    Fraction of_angle{-1};
    for (int i = 1; i <= product.derivative; ++i) of_angle = of_angle * Fraction{-i};
    add_to(derivative, rest, f * of_angle);
  }
  return derivative;
}

LineSum line_sum(int i, int j, int q) {
  const bool even = q % 2 == 0;
  if (even && q == 2) {
    LineSum angle;
    add_to(angle, function(0), {1});
    return angle;
  }
  const bool is_base = (q == 3 && i + j == 1) || (q == 1 && i + j <= 1) || (q == -1 && i + j <= 1);
  if (is_base) return base(i, j, q);
  // d r^(2-q) = -(q-2) r^(-q) times (1-u)^2 by a^2/2, times u^2 by b^2/2, times u(1-u) by g.
  const Fraction over{-1, q - 2};
  const auto squared = even ? angle_by_square : by_square;
  if (i >= 2) return over * squared(line_sum(i - 2, j, q - 2), A);
  if (j >= 2) return over * squared(line_sum(i, j - 2, q - 2), B);
  return over * (even ? angle_by_product : by_product)(line_sum(i - 1, j - 1, q - 2));
}

}  // namespace

LineFormula line_formula(int i, int j, int q) {
  const int excess = i + j - q;
  const bool even = q % 2 == 0;
  if (q < (even ? 2 : -1) || excess < kLeastExcess || excess > (even ? kLeastExcess : kMostExcess) || i < 0 || j < 0)
    throw std::logic_error("no formula along a line");
  LineFormula formula;
  const LineSum sum = line_sum(i, j, q);
  for (const auto& [product, f] : sum) formula.denominator = std::lcm(formula.denominator, f.bottom);
  for (const auto& [product, f] : sum) {
    const long factor = f.top * (formula.denominator / f.bottom);
    if (!std::in_range<int>(factor)) throw std::overflow_error("a factor along a line is too large");
    formula.terms.push_back({product, static_cast<int>(factor)});
  }
  if (!std::in_range<int>(formula.denominator)) throw std::overflow_error("a denominator along a line is too large");
  return formula;
}

}  // namespace cageproof::quadrature_ref::certified
