// SPDX-License-Identifier: MIT
// Gauss-Legendre rules in what closed forms on a segment are templates over, as few points as an error bound allows.
#pragma once

#include "cageproof/closed_form/segment/engine/frame.h"
#include "cageproof/core/gauss_legendre.h"

#include <map>
#include <memory>
#include <mutex>
#include <vector>

namespace cageproof::closed_form::segment {

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

/// The rule of n points.
template <Scalar R>
const auto& rule_of(int n) {
  if constexpr (is_tracked<R>) return tracked_rule(n);
  else return cageproof::gauss_legendre<R>(n);
}

/// log10 of a bound of the relative error of n points for the hat functions over z or z^2. The integrand is analytic
/// within the ellipse about the ends on which the point lies, whose half axes are (rho + 1/rho)/2 and (rho - 1/rho)/2
/// half lengths, and the rule's error falls like rho^(-2n). One degree of those that the rule is exact for goes to the
/// hat function, and each power of 1/z may raise the integrand on a slightly smaller ellipse by n.
inline double log10_far_error(int n, double rho) {
  return std::log10(4 * (1.0 + n) * (1.0 + n)) - (2 * n - 1) * std::log10(rho);
}

/// The fewest points for a quarter of a rounding. \pre the point is farther away than the segment's length
template <Scalar R>
int far_points(const Frame<R>& f) {
  const double sum = static_cast<double>((f.r[0] + f.r[1]) / f.length), rho = sum + std::sqrt(sum * sum - 1);
  int n = 2;
  const double rounding = is_multiprecision<R> ? -std::numeric_limits<R>::digits10 : std::log10(0x1p-55);
  while (log10_far_error(n, rho) > rounding) ++n;
  return n;
}

}  // namespace cageproof::closed_form::segment
