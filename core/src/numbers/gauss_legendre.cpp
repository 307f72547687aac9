// SPDX-License-Identifier: MIT
#include "cageproof/core/numbers/gauss_legendre.h"

#include <cmath>
#include <map>
#include <mutex>
#include <numbers>
#include <vector>

namespace cageproof {
namespace {

// The Legendre polynomial P_n. Coefficients of the recurrence are kept: dividing costs as much as the rest of a step.
template <class Real>
class Legendre {
 public:
  explicit Legendre(int n) : n_(n) {
    for (int k = 1; k < n; ++k) {
      of_before_.push_back(Real(k) / (k + 1));
      of_last_.push_back(1 + of_before_.back());
    }
  }

  struct AtPoint {
    Real value, slope;
  };
  // The slope is n (P_(n-1) - x P_n) / (1 - x^2), which cancels nothing next to a zero.
  AtPoint at(const Real& x) const {
    Real before = 1, last = x;
    for (std::size_t k = 0; k < of_last_.size(); ++k) {
      const Real next = of_last_[k] * x * last - of_before_[k] * before;
      before = last;
      last = next;
    }
    return {last, n_ * (before - x * last) / ((1 - x) * (1 + x))};
  }

 private:
  int n_;
  std::vector<Real> of_last_, of_before_;  // (2 k + 1) / (k + 1) and k / (k + 1)
};

// The k-th zero from the right, to about double's digits.
double rough_zero(const Legendre<double>& legendre, int n, int k) {
  double x = std::cos(std::numbers::pi * (4 * k + 3) / (4 * n + 2));
  for (int iteration = 0; iteration < 4; ++iteration) {
    const auto [value, slope] = legendre.at(x);
    x -= value / slope;
  }
  return x;
}

// Newton's method on P_n, at R's precision where double's ends: there a step costs as much as hundreds do in double.
template <Scalar R>
std::unique_ptr<GaussLegendre<R>> make_rule(int n) {
  auto rule = std::make_unique<GaussLegendre<R>>();
  rule->nodes.resize(n);
  rule->weights.resize(n);
  const Legendre<double> rough(n);
  const Legendre<R> legendre(n);
  for (int k = 0; k < (n + 1) / 2; ++k) {
    const bool middle = 2 * k + 1 == n;
    R x = middle ? R(0) : R(rough_zero(rough, n, k));
    R step = middle ? 0 : 1;
    // A step leaves an error of its square times x / (1 - x^2), which is at most n^2 at a zero.
    for (int iteration = 0; iteration < 64 && step * step * n * n > unit_roundoff<R>(); ++iteration) {
      const auto [value, slope] = legendre.at(x);
      step = value / slope;
      x -= step;
    }
    // With what rounding leaves of P_n: without it the weight would be off by n times as much as x is.
    const R slope = legendre.at(x).slope;
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
