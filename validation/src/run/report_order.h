// SPDX-License-Identifier: MIT
#pragma once

#include "cageproof/core/results/run_result.h"

namespace cageproof::validation {

/// Sorts rows as people read them: formulas, regimes, checks and evaluations as their lists have them, then cages; what
/// no list knows comes last, by name.
void sort_for_report(std::vector<ResultRow>& rows);

}  // namespace cageproof::validation
