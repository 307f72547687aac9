// SPDX-License-Identifier: MIT
// Summary of the coordinates of many points for a user: where the points lie, which have no coordinates, and how well
// the others reproduce.
#pragma once

#include "cageproof/core/coordinates/coordinates.h"

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

namespace cageproof::validation {

/// A quantity's largest value, and the point that has it, counted from 0.
struct Largest {
  double value = 0;
  std::size_t point = 0;
};

/// How many points there are of a sort, and the first of them, counted from 0.
struct Counted {
  std::size_t points = 0, first = 0;
};

struct CoordinateSummary {
  std::size_t points = 0;
  std::size_t inside = 0, on = 0, outside = 0;  ///< the cage, on it decided exactly
  std::size_t missing = 0;                      ///< points with NaN among their values
  std::size_t infinite = 0;                     ///< points with an infinity among them, and no NaN
  std::size_t inexact = 0;      ///< points with values whose sum is wrong in the eighth digit, or before
  std::size_t inexact_far = 0;  ///< those of them that are further than the cage's size from its bounding box
  Largest partition;            ///< |sum - 1|, or |sum| outside kinds that vanish there
  Largest reproduction;         ///< distance of the reproduced point, in cage sizes
  /// Points that coordinates whose sum is right give back to fewer than 8 digits of the cage's size, because the cage
  /// is so small compared with its distance from the origin.
  std::size_t misplaced = 0;
  double far_off = 0;       ///< the largest number among the cage's vertices, in cage sizes
  double grain = 0;         ///< how far apart doubles are there, in cage sizes
  bool reproduces = false;  ///< whether the kind reproduces points at all

  /// Points with finite values and some derivatives that are not finite: on the cage; off it with a NaN among them; and
  /// off it with infinities only.
  Counted derivatives_on, derivatives_missing, derivatives_infinite;

  std::size_t without_derivatives() const {
    return derivatives_on.points + derivatives_missing.points + derivatives_infinite.points;
  }

  /// Points that a mesh cannot be deformed at: without finite coordinates, or where the coordinates' sum is zero.
  std::size_t unusable = 0;
};

/// Makes a summary of coordinates while these are computed, a block of points at a time.
class SummaryMaker {
 public:
  /// Keeps references. \param order the highest derivative that rows hold
  SummaryMaker(const CageCoordinates& coordinates, const Cage& cage, int order);
  ~SummaryMaker();
  SummaryMaker(const SummaryMaker&) = delete;
  SummaryMaker& operator=(const SummaryMaker&) = delete;

  /// Looks at points that no other call looks at; from any thread, in any order.
  /// \param first the first point's number \param rows of these points, as the table of summary_of()
  void add(std::size_t first, std::span<const Vec3<double>> points, std::span<const double> rows);

  /// The summary of all points that were added.
  CoordinateSummary summary() const;

 private:
  class State;
  std::unique_ptr<State> state_;
};

/// \param table one row per point; in a row block by block, all values of a block, then all its derivatives
/// \param jobs threads; 0: all cores
CoordinateSummary summary_of(const CageCoordinates& coordinates, const Cage& cage,
                             const std::vector<Vec3<double>>& points, std::span<const double> table, int jobs);

}  // namespace cageproof::validation
