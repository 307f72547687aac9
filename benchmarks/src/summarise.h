// SPDX-License-Identifier: MIT
// What a row of a study says of its samples' errors.
#pragma once

#include "cageproof/core/work_precision.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace cageproof::benchmarks {

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

}  // namespace cageproof::benchmarks
