// SPDX-License-Identifier: MIT
// Makes a row of a study from its samples' errors and times.
#pragma once

#include "cageproof/benchmarks/work_precision.h"
#include "cageproof/core/results/work_precision.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

namespace cageproof::benchmarks {

/// Sets place, distance, and the sweep of those groups that are one distance from the cage.
inline void set_place(const PointGroup& group, WorkPrecisionRow& row) {
  row.place = group.place;
  row.distance = group.distance;
  if (group.place == "interior") return;
  row.sweep = "distance";
  row.axis = "distance / cage size";
}

/// Sets samples, nonfinite, largest, rms and median. An error that is not finite counts as infinite.
inline void summarise(std::vector<double> errors, WorkPrecisionRow& row) {
  row.samples = errors.size();
  if (errors.empty()) return;
  double squares = 0;
  for (double& e : errors) {
    if (!std::isfinite(e)) e = HUGE_VAL, ++row.nonfinite;
    squares += e * e;
  }
  std::ranges::sort(errors);
  row.largest = errors.back();
  row.rms = std::sqrt(squares / static_cast<double>(errors.size()));
  row.median = errors[(errors.size() - 1) / 2];
}

/// Sets timed and the three times, from one time of each pair or point. \pre there are some
inline void summarise_times(std::vector<double> nanoseconds, WorkPrecisionRow& row) {
  const std::size_t count = nanoseconds.size();
  std::ranges::sort(nanoseconds);
  row.timed = count;
  row.nanoseconds = std::accumulate(nanoseconds.begin(), nanoseconds.end(), 0.0) / static_cast<double>(count);
  row.median_nanoseconds = nanoseconds[(count - 1) / 2];
  row.quantile_nanoseconds = nanoseconds[count - 1 - count / 1000];
}

}  // namespace cageproof::benchmarks
