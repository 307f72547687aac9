// SPDX-License-Identifier: MIT
// Where a cage stood, as files had it before cases had a frame: the unit and the shift as four parameters.
#pragma once

#include "cageproof/core/results/error_measure.h"

#include <utility>
#include <vector>

namespace cageproof::reports {

/// Makes a cage's four parameters its frame; others stay as they are.
inline void take_older_frame(WorstCase& worst) {
  if (worst.parameters.size() != 4) return;
  const std::vector<double> p = std::exchange(worst.parameters, {});
  worst.frame = {{p[1], p[2], p[3]}, p[0]};
}

}  // namespace cageproof::reports
