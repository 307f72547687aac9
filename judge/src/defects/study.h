// SPDX-License-Identifier: MIT
// One implementation on all probes, and what the whole of its errors looks like.
#pragma once

#include "defects/probes.h"

namespace cageproof::judge {

/// A result at a probe, of one order.
struct Case {
  const Probe* probe = nullptr;
  int order = 0;
  Result<double> found;
  double error = 0;     ///< conditioned, in units of u
  double relative = 0;  ///< |found - truth| / |truth|
  bool bad = false;     ///< above limit_of()
  bool finite = true;   ///< all of its entries are
};

/// Facts of one order that no single result shows.
struct Pattern {
  bool everywhere = false;         ///< half of all generic results are bad
  bool quadrature = false;         ///< errors rise smoothly towards the element, and vanish some sizes away
  bool in_proportion = false;      ///< and they are ours times a factor of the sample
  bool right_in_sum = false;       ///< and the sum over the corners is right
  bool right_when_closed = false;  ///< and the sum over the faces of a closed cage is right
  double generic_error = 0;        ///< largest relative error of generic results that are bad
  double plane_slope = 0;          ///< exponent of one over the height that errors near the plane grow with; 0: none
  double edge_slope = 0;       ///< exponent of the distance from an edge that the relative error grows with; 0: none
  double projected_below = 0;  ///< largest height at which results are those of the feet, if three or more are; 0: none
  bool far = false, sliver = false;  ///< it is bad far away, or on slivers and needles, and not in the generic regime
  double far_slope = 0, plain_far_slope = 0;  ///< exponents of the distance that theirs and plain's errors grow with
  double sliver_slope = 0, plain_sliver_slope = 0;  ///< of one over the aspect
};

class Study {
 public:
  /// \param ours theirs in our convention
  /// \param sums_to_one theirs is divided by its sum, so that nothing is asked where that vanishes
  Study(const Evaluation& ours, std::uint64_t seed, int order, bool presets, bool sums_to_one);

  const Evaluation& evaluation() const { return ours_; }
  const Formula& formula() const { return ours_.formula(); }
  const Prober& prober() const { return prober_; }
  const std::vector<Case>& cases() const { return cases_; }
  const Pattern& pattern(int order) const { return patterns_[static_cast<std::size_t>(order)]; }
  std::size_t samples() const { return samples_; }
  Case ask(const Probe& probe, int order) const;
  Result<double> ask(const validation::Sample& sample, int order) const;

 private:
  Evaluation ours_;
  Prober prober_;
  std::vector<Case> cases_;
  std::array<Pattern, 2> patterns_{};
  std::size_t samples_ = 0;
};

/// The largest difference of a finite result's entries from the truth.
double off_by(const Case& c);

/// Whether a result is that of the point's foot in the plane, and the truth is not; or neither result is finite. The
/// point lies within a hundredth of a size of the plane, and not in it.
bool is_projected(const Study& study, const Case& c);

/// The patterns of one order. \pre study.cases() is complete
Pattern pattern_of(const Study& study, int order, std::uint64_t seed);

}  // namespace cageproof::judge
