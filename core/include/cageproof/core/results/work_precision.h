// SPDX-License-Identifier: MIT
// Time and error side by side: what `cageproof bench` measures and reports show.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace cageproof {

/// One evaluation at one place.
struct WorkPrecisionRow {
  std::string evaluation;
  std::string place;    ///< "interior", "1e-2" ... (distance from the cage, in its sizes), or a regime
  double distance = 0;  ///< of the place, in cage sizes, or the regime's swept parameter; 0 where there is none
  /// The sweep whose rows make curves over `distance`: a regime, or "distance" for cages; empty where nothing is swept.
  std::string sweep;
  std::string axis;  ///< what `distance` is: "distance / size"
  std::uint64_t samples = 0;
  std::uint64_t nonfinite = 0;  ///< errors that are not finite
  double largest = 0, rms = 0,
         median = 0;            ///< of the errors, in WorkPrecision::unit; one that is not finite counts as infinite
  std::optional<double> units;  ///< the largest conditioned error of a formula, in u
  double nodes = 0;             ///< mean kernel evaluations of one formula on one element; 0 for closed forms
  /// Times on one thread of the set that WorkPrecision::timed names, over all formulas of the subject: the mean, the
  /// median, and the 99.9 % quantile.
  double nanoseconds = 0, median_nanoseconds = 0, quantile_nanoseconds = 0;
  /// Pairs or points that were timed; below 1000 the quantile is the longest time. Of what computes many points at
  /// once, pairs by the thousand, whose median and quantile are those of whole calls.
  std::uint64_t timed = 0;
};

/// A whole measurement.
struct WorkPrecision {
  std::string subject;  ///< a formula, or a kind of cage coordinates
  std::string where;    ///< the cage, or "one element"
  std::string error;    ///< what the errors are: "partition of unity residual", "relative error"
  std::string unit;     ///< "1"
  std::string timed =
      "pair";  ///< what nanoseconds are of: a "pair" of point and element, or a "point" with the whole cage
  int order = 0;
  std::uint64_t seed = 0;
  std::string version, command_line, started;
  std::map<std::string, std::string> settings, machine;
  std::vector<WorkPrecisionRow> rows;  ///< place by place, evaluations in the order asked for
  std::vector<std::string> notes;      ///< places that have fewer samples than asked for ...
};

}  // namespace cageproof
