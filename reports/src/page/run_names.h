// SPDX-License-Identifier: MIT
// How a run's cages are called on its pages.
#pragma once

#include "cageproof/core/results/run_result.h"
#include "cageproof/reports/shown_names.h"

namespace cageproof::reports {

/// Names of the cages that have rows, and of the cage and the points that were given.
ShownNames names_of_run(const RunResult& result);

}  // namespace cageproof::reports
