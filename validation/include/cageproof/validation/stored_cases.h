// SPDX-License-Identifier: MIT
// The regression set: worst cases that hunts have found, kept in validation/data/worst_cases.jsonl and replayed in
// every run.
#pragma once

#include "cageproof/validation/measurement.h"

#include <string>
#include <string_view>

namespace cageproof::validation {

/// The file as it was when the program was built.
std::string_view stored_worst_cases();

/// Its name in messages and reports.
inline constexpr std::string_view stored_cases_file = "validation/data/worst_cases.jsonl";

/// Where a stored case's input comes from: its regimes and its line in the file; empty for an input that is not stored.
std::string origin_of(const RowKey& row, const WorstCase& input);

/// The contents of a worst-case file.
struct StoredCases {
  std::unique_ptr<const Measurement> measurement;  ///< null where there is no case
  std::size_t cases = 0;
};

/// The cases of a worst-case file, to be measured afresh: a row, in the regime `hunted`, for each formula, evaluation,
/// scalar, check and order. Patterns are globs; a case that they leave out is read all the same. \param text the file,
/// \param name what messages call it \throws InputError naming the line: what read_worst refuses, a case of a cage, or
/// one that can no longer be run
StoredCases stored_measurement(std::string_view text, std::string_view name, const std::string& formulas,
                               const std::string& evaluations);

/// Measures and judges them. \param jobs threads; 0: all cores. \throws InputError as stored_measurement
std::vector<ResultRow> replay_stored(std::string_view text, std::string_view name, const std::string& formulas,
                                     const std::string& evaluations, int jobs);

}  // namespace cageproof::validation
