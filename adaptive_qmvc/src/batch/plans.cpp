// SPDX-License-Identifier: MIT
#include "plans.h"

#include "cageproof/adaptive_qmvc/quad/mean_value/line_form/outer_rule.h"
#include "cageproof/core/gauss_legendre.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <list>

namespace cageproof::adaptive_qmvc::batch {
namespace {

// Of the integral: what roundings leave of a double.
constexpr double kDigits = 16;

// Lines across a quad.
constexpr std::array<int, 20> kNodes{4, 5, 6, 7, 8, 9, 10, 11, 12, 14, 16, 18, 20, 24, 32, 40, 52, 64, 96, kMostLines};

// About how many cycles a line takes, a node on it, and a line whose integral is elementary.
constexpr double kLineCost = 25, kNodeCost = 7.5, kElementaryCost = 150;

int nodes_for(double axis, double order) {
  return nodes_across(axis + std::sqrt(axis * axis - 1), 0.5, 0, order, kDigits);
}

// A rule with its memory.
struct OwnedRule {
  int nodes;
  std::array<std::vector<double>, 3> moment;
  Rule rule;
};

const Rule* rule_of(int nodes) {
  static std::list<OwnedRule> rules;
  for (const OwnedRule& owned : rules)
    if (owned.nodes == nodes) return &owned.rule;
  const GaussLegendre<double>& gauss = gauss_legendre<double>(nodes);
  OwnedRule& owned = rules.emplace_back();
  owned.nodes = nodes;
  for (int k = 0; k < nodes; ++k) {
    double power = 1;
    for (std::vector<double>& moment : owned.moment) {
      moment.push_back(gauss.weights[k] * power);
      power *= gauss.nodes[k];
    }
  }
  owned.rule = {nodes, gauss.nodes.data(), {owned.moment[0].data(), owned.moment[1].data(), owned.moment[2].data()}};
  return &owned.rule;
}

}  // namespace

const Plans& Plans::get() {
  static const Plans plans;
  return plans;
}

Plans::Plans() {
  static_assert(kNodes.size() == kClasses);
  // Across lines an integrand with half an order less than on them.
  constexpr double kAcross = 1.5, kAlong = 2;
  std::array<int, kClasses> along{};
  step_.fill(kClasses);
  for (int i = 1; i < kSteps; ++i) {
    const double axis = 1 + i / kStepsPerAxis;
    const int nodes = nodes_for(axis, kAcross);
    const auto* const found = std::ranges::lower_bound(kNodes, nodes);
    if (found == kNodes.end()) continue;
    const auto step = static_cast<std::size_t>(found - kNodes.begin());
    step_[i] = static_cast<std::uint8_t>(step);
    // By twos.
    along[step] = std::max(along[step], (nodes_for(axis, kAlong) + 1) / 2 * 2);
  }
  for (int v = 0; v <= kClasses; ++v)
    for (int u = 0; u <= kClasses; ++u) {
      double least = std::numeric_limits<double>::infinity();
      Plan best{};
      const auto offer = [&](bool turned, int across, int nodes_along) {
        const double cost = kNodes[across] * (nodes_along > 0 ? kLineCost + kNodeCost * nodes_along : kElementaryCost);
        if (!(cost < least)) return;
        least = cost;
        best = {turned, rule_of(kNodes[across]), nodes_along > 0 ? rule_of(nodes_along) : nullptr};
      };
      if (v < kClasses && u < kClasses) {
        offer(false, v, along[u]);
        offer(true, u, along[v]);
      }
      if (v < kClasses) offer(false, v, 0);
      if (u < kClasses) offer(true, u, 0);
      if (best.across == nullptr) continue;
      const auto same = std::ranges::find_if(plans_, [&](const Plan& plan) {
        return plan.turned == best.turned && plan.across == best.across && plan.along == best.along;
      });
      choice_[v][u] = static_cast<std::uint16_t>(same - plans_.begin());
      if (same == plans_.end()) plans_.push_back(best);
    }
  choice_[kClasses][kClasses] = static_cast<std::uint16_t>(plans_.size());
}

}  // namespace cageproof::adaptive_qmvc::batch
