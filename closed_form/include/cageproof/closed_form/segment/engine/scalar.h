// SPDX-License-Identifier: MIT
// What closed forms on a segment are templates over: the scalars of formulas, and doubles that bound their own error.
#pragma once

#include "cageproof/closed_form/arithmetic/tracked.h"
#include "cageproof/core/gauss_legendre.h"

#include <map>
#include <memory>
#include <mutex>

namespace cageproof::closed_form::segment {

/// In this folder a scalar is also a double that carries a bound of its own error.
template <class R>
concept Scalar = cageproof::Scalar<R> || std::same_as<R, Tracked<double>>;

template <Scalar R>
R unit_roundoff() {
  if constexpr (is_tracked<R>) return R(cageproof::unit_roundoff<double>());
  else return cageproof::unit_roundoff<R>();
}
template <Scalar R>
R pi() {
  if constexpr (is_tracked<R>) return R::rounded(cageproof::pi<double>(), 0);
  else return cageproof::pi<R>();
}
template <Scalar R>
R ln_two() {
  if constexpr (is_tracked<R>) return R::rounded(cageproof::ln_two<double>(), 0);
  else return cageproof::ln_two<R>();
}

/// A rule of rounded nodes and weights.
struct TrackedRule {
  std::vector<Tracked<double>> nodes, weights;
};

/// Computed once an n, safe from any thread.
inline const TrackedRule& tracked_rule(int n) {
  static std::mutex mutex;
  static std::map<int, std::unique_ptr<TrackedRule>> rules;
  const std::scoped_lock lock(mutex);
  auto& rule = rules[n];
  if (rule) return *rule;
  rule = std::make_unique<TrackedRule>();
  const auto& plain = cageproof::gauss_legendre<double>(n);
  for (const double x : plain.nodes) rule->nodes.push_back(Tracked<double>::rounded(x, 0));
  for (const double w : plain.weights) rule->weights.push_back(Tracked<double>::rounded(w, 0));
  return *rule;
}

template <Scalar R>
const auto& gauss_legendre(int n) {
  if constexpr (is_tracked<R>) return tracked_rule(n);
  else return cageproof::gauss_legendre<R>(n);
}

}  // namespace cageproof::closed_form::segment
