// SPDX-License-Identifier: MIT
#include "plans.h"

#include "chunk_size.h"

#include "quad/engine/outer_rule.h"
#include "cageproof/core/numbers/gauss_legendre.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace cageproof::adaptive_qmvc::batch {
namespace {

// Rules for the line form's mean value weights. Roundings leave sixteen digits of a double. Across lines an integrand
// has half an order less than along them.
constexpr PlanRules kMeanValues{
    .digits = 16,
    .across = 1.5,
    .along = 2,
    .nodes = {4, 5, 6, 7, 8, 9, 10, 11, 12, 14, 16, 18, 20, 24, 32, 40, 52, 64, 96, kMostLines},
    .line_cost = 25,
    .node_cost = 7.5,
    .elementary_cost = 150,
    .most_distant = 0};

// Of 1/r and N.x/r^3, whose integrals along lines are always taken from elementary functions.
constexpr PlanRules kLayers{.digits = 13,
                            .across = 1,
                            .along = 0,
                            .nodes = {4, 5, 6, 7, 8, 10, 12, 14, 16, 18, 20, 24, 28, 32, 40, 48, 56, 64, 80, 96},
                            .line_cost = 1,
                            .node_cost = 1,
                            .elementary_cost = 1,
                            .most_distant = 64};

int nodes_for(double axis, double order, double digits) {
  return nodes_across(axis + std::sqrt(axis * axis - 1), 0.5, 0, order, digits);
}

}  // namespace

const Rule* Plans::rule_of(int nodes) {
  for (const OwnedRule& owned : rules_)
    if (owned.rule.count == nodes) return &owned.rule;
  const GaussLegendre<double>& gauss = gauss_legendre<double>(nodes);
  OwnedRule& owned = rules_.emplace_back();
  owned.node = gauss.nodes;
  for (int k = 0; k < nodes; ++k) {
    double power = 1;
    for (std::vector<double>& moment : owned.moment) {
      moment.push_back(gauss.weights[k] * power);
      power *= gauss.nodes[k];
    }
  }
  owned.node.resize(nodes + kWidest, 0.0);
  for (std::vector<double>& moment : owned.moment) moment.resize(nodes + kWidest, 0.0);
  owned.rule = {nodes, owned.node.data(), {owned.moment[0].data(), owned.moment[1].data(), owned.moment[2].data()}};
  return &owned.rule;
}

const Plans& Plans::of_mean_values() {
  static const Plans plans(kMeanValues);
  return plans;
}

const Plans& Plans::of_layers() {
  static const Plans plans(kLayers);
  return plans;
}

Plans::Plans(const PlanRules& rules) {
  static_assert(std::tuple_size_v<decltype(rules.nodes)> == kClasses);
  const auto& nodes_of = rules.nodes;
  std::ranges::copy(nodes_of, lines_.begin());
  std::array<int, kClasses> along{};
  step_.fill(kClasses);
  for (int i = 1; i < kSteps; ++i) {
    const double axis = 1 + i / kStepsPerAxis;
    const auto* const found = std::ranges::lower_bound(nodes_of, nodes_for(axis, rules.across, rules.digits));
    if (found == nodes_of.end()) continue;
    const auto step = static_cast<std::size_t>(found - nodes_of.begin());
    step_[i] = static_cast<std::uint8_t>(step);
    // By twos.
    along[step] = std::max(along[step], (nodes_for(axis, rules.along, rules.digits) + 1) / 2 * 2);
  }
  for (int v = 0; v <= kClasses; ++v)
    for (int u = 0; u <= kClasses; ++u) {
      double least = std::numeric_limits<double>::infinity();
      Plan best{};
      const auto offer = [&](bool turned, int across, int nodes_along, bool close) {
        const double cost = nodes_of[across] *
                            (nodes_along > 0 ? rules.line_cost + rules.node_cost * nodes_along : rules.elementary_cost);
        if (!(cost < least)) return;
        least = cost;
        best = {turned, rule_of(nodes_of[across]), nodes_along > 0 ? rule_of(nodes_along) : nullptr, close};
      };
      if (v < kClasses && u < kClasses) {
        if (rules.along > 0) offer(false, v, along[u], false), offer(true, u, along[v], false);
      }
      const auto is_close = [&](int lines) { return lines == kClasses || nodes_of[lines] > rules.most_distant; };
      if (v < kClasses) offer(false, v, 0, is_close(u));
      if (u < kClasses) offer(true, u, 0, is_close(v));
      if (best.across == nullptr) continue;
      const auto same = std::ranges::find_if(plans_, [&](const Plan& plan) {
        return plan.turned == best.turned && plan.across == best.across && plan.along == best.along &&
               plan.close == best.close;
      });
      choice_[v][u] = static_cast<std::uint16_t>(same - plans_.begin());
      if (same == plans_.end()) plans_.push_back(best);
    }
  choice_[kClasses][kClasses] = static_cast<std::uint16_t>(plans_.size());
}

}  // namespace cageproof::adaptive_qmvc::batch
