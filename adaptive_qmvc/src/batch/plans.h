// SPDX-License-Identifier: MIT
// How a quad is integrated over, by the distances of a point from its sides.
#pragma once

#include "tables.h"

#include <array>
#include <cstdint>
#include <list>
#include <vector>

namespace cageproof::adaptive_qmvc::batch {

/// A way to integrate over a quad.
struct Plan {
  bool turned;  ///< lines along the sides from corner 0 to corner 3 instead of those from 0 to 1
  const Rule* across;
  const Rule* along;  ///< null: elementary
  bool close;         ///< whether points may be next to lines: where no rule is taken along them, or one of many nodes
};

/// The parts that plans are made of.
struct PlanRules {
  double digits;  ///< of the integral
  /// Orders of the integrand's singularities, across the lines and on them (nodes_across); zero for no nodes on lines.
  double across, along;
  std::array<int, 20> nodes;  ///< lines across a quad, rising
  /// About how many cycles a line takes, a node on it, and a line whose integral is elementary.
  double line_cost, node_cost, elementary_cost;
  /// As many lines or fewer are enough for points whose distances from both ends of a line that way add up to 1.05 of
  /// its lengths or more; zero where no plan asks.
  int most_distant;
};

/// The plans that points choose from. The sum of the distances from two opposite sides, over the longer one of the
/// others, bounds the ellipse that the integrand is analytic in across them (plain_nodes): it gives the nodes.
class Plans {
 public:
  /// Plans of mean value weights, and of single and double layers: one object each, made when first asked for.
  static const Plans& of_mean_values();
  static const Plans& of_layers();

  /// The step of such a sum.
  int step_of(double axis) const {
    const double step = (axis - 1) * kStepsPerAxis;
    // Points next to a quad may sum up to less than one, by rounding.
    if (!(step >= 1)) return step_[0];
    return step_[step < kSteps - 1 ? static_cast<int>(step) : kSteps - 1];
  }
  /// The number of the plan for steps of the sums across the lines v and u, or none().
  int plan_of(int across_v, int across_u) const { return choice_[across_v][across_u]; }
  /// How many lines a sum of distances from both outermost ones asks for, or 0 where it is too small.
  int lines_for(double axis) const { return lines_[step_of(axis)]; }
  int none() const { return static_cast<int>(plans_.size()); }
  int count() const { return static_cast<int>(plans_.size()); }
  const Plan& operator[](int plan) const { return plans_[plan]; }

 private:
  explicit Plans(const PlanRules& rules);

  static constexpr int kSteps = 4096;
  static constexpr double kStepsPerAxis = 256;
  static constexpr int kClasses = 20;  // and one for what no rule is taken for

  std::array<std::uint8_t, kSteps> step_{};
  std::array<int, kClasses + 1> lines_{};
  // A rule with its memory.
  struct OwnedRule {
    std::vector<double> node;
    std::array<std::vector<double>, 3> moment;
    Rule rule;
  };
  const Rule* rule_of(int nodes);

  std::uint16_t choice_[kClasses + 1][kClasses + 1];
  std::list<OwnedRule> rules_;
  std::vector<Plan> plans_;
};

}  // namespace cageproof::adaptive_qmvc::batch
