// SPDX-License-Identifier: MIT
// Integrals over [0, 1] of functions that are smooth except at complex poles, by Gauss points on panels.
#pragma once

#include "cageproof/core/numbers/linear.h"

#include <complex>
#include <vector>

namespace cageproof::second_routes {

/// A Gauss-Legendre rule on [0, 1] in 100 digits, computed here: `core` has nodes too, but closed forms' neighbours
/// take those.
struct GaussRule {
  std::vector<Mp100> nodes, weights;
  explicit GaussRule(int count);
};

/// Of 52 nodes: on panels it has 57 digits. Computed once.
const GaussRule& gauss_rule();

/// Panels of [0, 1], each at least its own length away from every pole, so that each Gauss node gains 1.1 digits.
/// \param poles complex, as double knows them: where panels end changes no integral
std::vector<double> panel_ends(const std::vector<std::complex<double>>& poles);

/// Where the squared length of (1 - t) a + t b vanishes: a pair of conjugates, or nothing for vectors that are equal.
std::vector<std::complex<double>> zeros_of_length(const Vec3<double>& a, const Vec3<double>& b);

/// Adds up f(t) dt over the panels, with f(t, weight) called once per node.
template <class F>
void over_panels(const std::vector<double>& ends, const F& f) {
  const GaussRule& rule = gauss_rule();
  for (std::size_t k = 0; k + 1 < ends.size(); ++k) {
    const Mp100 from = ends[k], length = Mp100(ends[k + 1]) - from;
    for (std::size_t i = 0; i < rule.nodes.size(); ++i)
      f(Mp100(from + length * rule.nodes[i]), Mp100(length * rule.weights[i]));
  }
}

}  // namespace cageproof::second_routes
