// SPDX-License-Identifier: MIT
#include "cageproof/core/numbers/gauss_legendre.h"

#include <array>
#include <cmath>
#include <map>
#include <mutex>
#include <numbers>

namespace cageproof {
namespace {

// P_n and P_(n-1) at x, by their recurrence.
template <class Real>
std::array<Real, 2> legendre_pair(int n, const Real& x) {
  Real before = 1, last = x;
  for (int k = 1; k < n; ++k) {
    const Real next = ((2 * k + 1) * x * last - k * before) / (k + 1);
    before = last;
    last = next;
  }
  return {last, before};
}

// P_n and its derivative n (P_(n-1) - x P_n) / (1 - x^2), which cancels nothing next to a zero.
template <class Real>
std::array<Real, 2> legendre(int n, const Real& x) {
  const auto [last, before] = legendre_pair(n, x);
  return {last, n * (before - x * last) / ((1 - x) * (1 + x))};
}

// The k-th zero from the right, to about double's digits.
double rough_zero(int n, int k) {
  double x = std::cos(std::numbers::pi * (4 * k + 3) / (4 * n + 2));
  for (int iteration = 0; iteration < 4; ++iteration) {
    const auto [value, slope] = legendre(n, x);
    x -= value / slope;
  }
  return x;
}

// Newton's method on P_n, at R's precision where double's ends: each step doubles the digits, and costs as much there
// as hundreds do in double.
template <Scalar R>
std::unique_ptr<GaussLegendre<R>> make_rule(int n) {
  auto rule = std::make_unique<GaussLegendre<R>>();
  rule->nodes.resize(n);
  rule->weights.resize(n);
  for (int k = 0; k < (n + 1) / 2; ++k) {
    const bool middle = 2 * k + 1 == n;
    R x = middle ? R(0) : R(rough_zero(n, k));
    R step = middle ? 0 : 1;
    for (int iteration = 0; iteration < 64 && abs(step) > 4 * unit_roundoff<R>(); ++iteration) {
      const auto [value, slope] = legendre(n, x);
      step = value / slope;
      x -= step;
    }
    // With what rounding leaves of P_n: without it the weight would be off by n times as much as x is.
    const R slope = legendre(n, x)[1];
    const R weight = 1 / ((1 - x) * (1 + x) * slope * slope);
    rule->nodes[k] = (1 - x) / 2;
    rule->nodes[n - 1 - k] = (1 + x) / 2;
    rule->weights[k] = rule->weights[n - 1 - k] = weight;
  }
  return rule;
}

// The nodes of float and double come from 50 digits, so that they are correctly rounded.
template <Scalar R>
std::unique_ptr<GaussLegendre<R>> make(int n) {
  if constexpr (is_multiprecision<R>) {
    return make_rule<R>(n);
  } else {
    const GaussLegendre<Mp50>& wide = gauss_legendre<Mp50>(n);
    auto rule = std::make_unique<GaussLegendre<R>>();
    for (const Mp50& x : wide.nodes) rule->nodes.push_back(static_cast<R>(x));
    for (const Mp50& w : wide.weights) rule->weights.push_back(static_cast<R>(w));
    return rule;
  }
}

}  // namespace

template <Scalar R>
const GaussLegendre<R>& gauss_legendre(int n) {
  static std::mutex mutex;
  static std::map<int, std::unique_ptr<GaussLegendre<R>>> rules;
  const std::scoped_lock lock(mutex);
  auto& rule = rules[n];
  if (!rule) rule = make<R>(n);
  return *rule;
}

template const GaussLegendre<float>& gauss_legendre<float>(int);
template const GaussLegendre<double>& gauss_legendre<double>(int);
template const GaussLegendre<Mp50>& gauss_legendre<Mp50>(int);
template const GaussLegendre<Mp100>& gauss_legendre<Mp100>(int);
template const GaussLegendre<Mp200>& gauss_legendre<Mp200>(int);

}  // namespace cageproof
