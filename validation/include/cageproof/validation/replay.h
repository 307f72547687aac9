// SPDX-License-Identifier: MIT
#pragma once

#include "cageproof/core/cage.h"
#include "cageproof/core/tally.h"
#include "cageproof/validation/check.h"

namespace cageproof::validation {

/// Re-runs a worst case of a row, from its names alone: what the row's check finds there now at the row's order (an
/// error in the row's unit, or why there is none). \throws InputError when a name is unknown (formula, evaluation,
/// scalar, check, kind), the input is none of the formula, a cage cannot be read, or
///   the check is not asked of the evaluation
Finding replay(const RowKey& row, const WorstCase& worst, Triangulation rule);

/// Throws what replay would throw for a case of a single element, and measures nothing.
void require_replayable(const RowKey& row, const WorstCase& worst);

}  // namespace cageproof::validation
