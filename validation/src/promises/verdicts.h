// SPDX-License-Identifier: MIT
// From tallies to judged rows: the one way in which a row of results is made.
#pragma once

#include "cageproof/core/results/partial_result.h"

namespace cageproof::validation {

/// The role of a row's evaluation by the program's register, as RowFigures has it.
std::string role_of(const RowKey& key);

/// The row of a tally: its figures, and bound, reason and verdict from the table of promises.
ResultRow row_of(const RowKey& key, const Tally& tally);

/// Sets bound, reason and verdict of a row from the table of promises.
void judge(ResultRow& row);

/// Number of samples that a row should have measured and did not: those without a truth, those that an evaluation
/// declined without being allowed to, and those without any finding.
std::uint64_t lost_samples(const ResultRow& row);

/// Verdicts and rows of all findings, in the order in which reports list them.
struct Judged {
  std::vector<ResultRow> rows;
  std::vector<ResultCurve> curves;
  std::vector<std::string> notes;  ///< where the closed form in multiprecision is not the integral
};

/// Whether a run measured as many samples as its suite does, or fewer.
enum class Samples { All, Fewer };

/// Judges all tallies of a run together, and lets go of each as its row is made: a run has fifty thousand. Where the
/// truth is not confirmed by the integral, nothing that was measured against it counts. Where anything was promised
/// there, the integral's own row is broken if it disagrees; if it could say nothing, the row is undecided, and broken
/// where all samples of the suite were asked.
Judged judged(std::map<RowKey, Tally>&& tallies, Samples samples = Samples::Fewer);

}  // namespace cageproof::validation
