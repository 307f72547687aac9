// SPDX-License-Identifier: MIT
#pragma once

#include "cageproof/core/cage.h"
#include "cageproof/core/run_result.h"

namespace cageproof::validation {

/// Re-runs a worst case of a row, from its names alone, and returns its error in the row's unit; NaN where there is no truth.
/// \throws InputError when a name is unknown (formula, evaluation, scalar, check, kind) or a cage cannot be read
double replay(const ResultRow& row, const WorstCase& worst, Triangulation rule);

}  // namespace cageproof::validation
