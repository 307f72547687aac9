// SPDX-License-Identifier: MIT
// How a quad is integrated over, by the distances of a point from its sides.
#pragma once

#include "tables.h"

#include <array>
#include <cstdint>
#include <vector>

namespace cageproof::adaptive_qmvc::batch {

/// A way to integrate over a quad.
struct Plan {
  bool turned;  ///< lines along the sides from corner 0 to corner 3 instead of those from 0 to 1
  const Rule* across;
  const Rule* along;  ///< null: elementary
};

/// The plans that points choose from. The sum of the distances from two opposite sides, over the longer one of the
/// others, bounds the ellipse that the integrand is analytic in across them (plain_nodes): it gives the nodes.
class Plans {
 public:
  /// The only object, made when first asked for.
  static const Plans& get();

  /// The step of such a sum.
  int step_of(double axis) const {
    const double step = (axis - 1) * kStepsPerAxis;
    // Points next to a quad may sum up to less than one, by rounding.
    if (!(step >= 1)) return step_[0];
    return step_[step < kSteps - 1 ? static_cast<int>(step) : kSteps - 1];
  }
  /// The number of the plan for steps of the sums across the lines v and u, or none().
  int plan_of(int across_v, int across_u) const { return choice_[across_v][across_u]; }
  int none() const { return static_cast<int>(plans_.size()); }
  int count() const { return static_cast<int>(plans_.size()); }
  const Plan& operator[](int plan) const { return plans_[plan]; }

 private:
  Plans();

  static constexpr int kSteps = 4096;
  static constexpr double kStepsPerAxis = 256;
  static constexpr int kClasses = 20;  // and one for what no rule is taken for

  std::array<std::uint8_t, kSteps> step_{};
  std::uint16_t choice_[kClasses + 1][kClasses + 1];
  std::vector<Plan> plans_;
};

}  // namespace cageproof::adaptive_qmvc::batch
