// SPDX-License-Identifier: MIT
// From tallies to judged rows: the one way in which a row of results is made.
#pragma once

#include "cageproof/core/findings.h"

namespace cageproof::validation {

/// The row of a tally: its figures, and bound, reason and verdict from the table of promises.
ResultRow row_of(const RowKey& key, const Tally& tally);

/// Sets bound, reason and verdict of a row from the table of promises.
void judge(ResultRow& row);

/// Whether a sample without truth is itself a failure: off the element every limit exists, so that there the closed
/// form in multiprecision has none to give. In float a sample may have rounded onto the element, or out of range.
bool truth_must_exist(const RowKey& key);

/// What findings amount to, in the order in which reports list them.
struct Judged {
  std::vector<ResultRow> rows;
  std::vector<ResultCurve> curves;
  std::vector<std::string> notes;  ///< what the integral did not confirm
};

/// Judges all tallies of a run together: where the truth is not confirmed by the integral, nothing that was measured
/// against it counts.
Judged judged(const std::map<RowKey, Tally>& tallies);

}  // namespace cageproof::validation
