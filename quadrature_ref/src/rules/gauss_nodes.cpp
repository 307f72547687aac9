// SPDX-License-Identifier: MIT
#include "gauss_nodes.h"

#include <cmath>
#include <map>
#include <memory>
#include <mutex>
#include <numbers>
#include <utility>
#include <vector>

namespace cageproof::quadrature_ref {
namespace {

// The number with half of W's digits, in which a root is found before W's last step.
template <class W>
struct HalfOf {
  using Type = double;
};
template <>
struct HalfOf<Mp100> {
  using Type = Mp50;
};
template <>
struct HalfOf<Mp200> {
  using Type = Mp100;
};
template <>
struct HalfOf<Mp400> {
  using Type = Mp200;
};

// The Legendre polynomials P_n and P_{n-1}, and the roots of P_n.
template <class W>
class Legendre {
 public:
  explicit Legendre(int n) : n_(n), half_(n) {
    ratios_.reserve(n);
    for (int k = 0; k < n; ++k) ratios_.push_back(W(k) / (k + 1));
  }

  struct Values {
    W here, before;
  };

  // (k + 1) P_{k+1} = (2k + 1) x P_k - k P_{k-1}, without a division.
  Values at(const W& x) const {
    W here = 1, before = 0;
    for (const W& ratio : ratios_) {
      const W product = x * here;
      before = product + ratio * (product - before);
      std::swap(here, before);
    }
    return {here, before};
  }

  // The k-th root from 1 downwards. A step of Newton's method doubles the digits, less those of n^2. From three digits,
  // where n is small, six steps reach 50.
  W root(int k) const {
    if (2 * k + 1 == n_) return 0;
    W x(half_.root(k));
    for (int step = 0; step < (std::same_as<W, Mp50> ? 6 : 1); ++step) x -= step_at(x);
    return x;
  }

 private:
  // (1 - x^2) P_n' = n (P_{n-1} - x P_n)
  W step_at(const W& x) const {
    const auto [here, before] = at(x);
    return here * ((1 - x) * (1 + x)) / (n_ * (before - x * here));
  }

  int n_;
  Legendre<typename HalfOf<W>::Type> half_;
  std::vector<W> ratios_;  // k / (k + 1)
};

// Where the steps begin: Tricomi's estimate.
template <>
class Legendre<double> {
 public:
  explicit Legendre(int n) : n_(n) {}
  double root(int k) const {
    const double n = n_, angle = std::numbers::pi * (4 * k + 3) / (4 * n + 2);
    return (1 - (n - 1) / (8 * n * n * n)) * std::cos(angle);
  }

 private:
  int n_;
};

// The type in which rules are computed: twice the digits, since recurrences lose some.
template <Scalar R>
using Working =
    std::conditional_t<std::same_as<R, Mp200>, Mp400, std::conditional_t<std::same_as<R, Mp100>, Mp200, Mp100>>;

template <Scalar R>
std::unique_ptr<GaussNodes<R>> made(int n) {
  using W = Working<R>;
  auto rule = std::make_unique<GaussNodes<R>>();
  rule->nodes.resize(n);
  rule->weights.resize(n);
  const Legendre<W> polynomial(n);
  for (int k = 0; k < (n + 1) / 2; ++k) {
    const W x = polynomial.root(k), p = n * polynomial.at(x).before;
    rule->nodes[k] = static_cast<R>((1 - x) / 2);
    rule->nodes[n - 1 - k] = static_cast<R>((1 + x) / 2);
    rule->weights[k] = rule->weights[n - 1 - k] = static_cast<R>((1 - x) * (1 + x) / (p * p));
  }
  return rule;
}

}  // namespace

template <Scalar R>
const GaussNodes<R>& gauss_nodes(int n) {
  static std::mutex mutex;
  static std::map<int, std::unique_ptr<GaussNodes<R>>> rules;
  const std::scoped_lock lock(mutex);
  auto& rule = rules[n];
  if (!rule) rule = made<R>(n);
  return *rule;
}

template const GaussNodes<float>& gauss_nodes<float>(int);
template const GaussNodes<double>& gauss_nodes<double>(int);
template const GaussNodes<Mp50>& gauss_nodes<Mp50>(int);
template const GaussNodes<Mp100>& gauss_nodes<Mp100>(int);
template const GaussNodes<Mp200>& gauss_nodes<Mp200>(int);

}  // namespace cageproof::quadrature_ref
