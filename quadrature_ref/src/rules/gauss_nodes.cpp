// SPDX-License-Identifier: MIT
#include "gauss_nodes.h"

#include <cmath>
#include <map>
#include <memory>
#include <mutex>
#include <numbers>

namespace cageproof::quadrature_ref {
namespace {

// P_n and P_{n-1} at x, by (k + 1) P_{k+1} = (2k + 1) x P_k - k P_{k-1}.
template <class R>
struct Legendre {
  R here = 1, before = 0;

  Legendre(int n, const R& x) {
    for (int k = 0; k < n; ++k) {
      R next = ((2 * k + 1) * x * here - k * before) / (k + 1);
      before = here;
      here = next;
    }
  }
};

// The k-th root of P_n from 1 downwards, by eight steps of Newton's method from Tricomi's estimate. Each step doubles
// the digits; from about eight, six steps reach W's.
template <class W>
W root(int n, int k) {
  if (2 * k + 1 == n) return 0;
  const double size = n, angle = std::numbers::pi * (4 * k + 3) / (4 * size + 2);
  W x((1 - (size - 1) / (8 * size * size * size)) * std::cos(angle));
  for (int step = 0; step < 8; ++step) {
    const Legendre<W> p(n, x);
    // (1 - x^2) P_n' = n (P_{n-1} - x P_n)
    x -= p.here * ((1 - x) * (1 + x)) / (n * (p.before - x * p.here));
  }
  return x;
}

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
  for (int k = 0; k < (n + 1) / 2; ++k) {
    const W x = root<W>(n, k), p = n * Legendre<W>(n, x).before;
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
