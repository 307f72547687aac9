// SPDX-License-Identifier: MIT
#include "cageproof/core/numbers/gauss_legendre.h"

#include "cageproof/core/numbers/mp_number.h"

#include <boost/math/special_functions/legendre.hpp>

#include <cmath>
#include <map>
#include <mutex>

namespace cageproof {
namespace {

// Newton's method on P_n at R's precision; Boost.Math's own zero finder loses its last digits at multiprecision.
template <Scalar R>
std::unique_ptr<GaussLegendre<R>> make_rule(int n) {
  auto rule = std::make_unique<GaussLegendre<R>>();
  rule->nodes.resize(n);
  rule->weights.resize(n);
  // Boost's polynomials take Boost's numbers.
  using Real = BoostReal<R>;
  for (int k = 0; k < (n + 1) / 2; ++k) {
    using std::abs, std::cos;
    R x = 2 * k + 1 == n ? R(0) : R(cos(pi<R>() * (4 * k + 3) / (4 * n + 2)));
    R step = 1;
    for (int iteration = 0; iteration < 64 && abs(step) > 4 * unit_roundoff<R>(); ++iteration) {
      step = x == 0
                 ? R(0)
                 : Real::from(boost::math::legendre_p(n, Real::to(x)) / boost::math::legendre_p_prime(n, Real::to(x)));
      x -= step;
    }
    const R derivative = Real::from(boost::math::legendre_p_prime(n, Real::to(x)));
    const R weight = 1 / ((1 - x) * (1 + x) * derivative * derivative);
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
