// SPDX-License-Identifier: MIT
// worst.jsonl: the worst inputs of a run, exactly, one JSON object a line.
#pragma once

#include "cageproof/core/results/run_result.h"

#include <filesystem>
#include <string_view>

namespace cageproof::reports {

/// The member of RunResult::settings of runs that have points outside their cage: "330 of 434".
inline constexpr const char* points_outside_setting = "points outside";

/// The member of RunResult::settings of runs that were asked for regimes which elements of their formulas do not have:
/// a sentence.
inline constexpr const char* regimes_nowhere_setting = "regimes without samples";

/// The member of RunResult::settings, and of a journal's options, that tells the content of the cage that is given by a
/// file: a fingerprint.
inline constexpr const char* cage_content_setting = "the cage's content";

/// One line: a worst case and the row it belongs to.
struct WorstLine : RowKey {
  std::string unit;  ///< of error and bound
  std::optional<double> bound;
  std::vector<std::string> flags;  ///< what the input exercises: the regime, or the place
  std::string triangulation;       ///< RunResult::settings["triangulation"], or empty
  std::string cage_content;  ///< of the cage that the row is of, RunResult::settings[cage_content_setting], or empty
  std::string provenance;    ///< how it was found, or empty
  int number = 0;            ///< of the line in its file, from 1
  WorstCase worst;           ///< corners, point, parameters and frame bit for bit
};

/// The lines of all rows that have worst cases, in the order of the rows: keys formula (kind for a cage), evaluation,
/// scalar, regime, check, place, order, unit, error, bound, parameter, sample, flags, element, point, parameters,
/// triangulation; where they say something cage_content (of a cage of a file), frame (unit and shift of a cage that
/// does not stand where it is), asked (highest derivative of the query, otherwise 2), provenance, relative (the plain
/// relative error) and furthest (the entry that is furthest from the truth: its index, what was found, the truth).
/// Coordinates and parameters are hexadecimal floats in strings; infinite errors the string "inf".
std::string worst_lines(const RunResult& result);

/// The line of a row's case.
WorstLine worst_line_of(const ResultRow& row, const WorstCase& worst, const RunResult& result);

/// One case as worst_lines writes it, without the line's end.
std::string worst_line(const WorstLine& line);

/// Reads a worst.jsonl, packed or not; blank lines are skipped; a line may have a key "remark".
/// \throws InputError naming file and line: missing or empty file, malformed JSON, missing or unknown key, wrong type,
/// bad number, unknown triangulation
std::vector<WorstLine> read_worst(const std::filesystem::path& path);

/// The same from text, which may be empty. \param name the file's name in messages
std::vector<WorstLine> parse_worst(std::string_view text, std::string_view name);

/// Adds cases to a worst-case file, made if it is missing. Every line that is there stays as it is. Of the new cases
/// those stay that are among the `few` worst of old and new with the same formula, evaluation, scalar, check, regime,
/// place and order, and whose input is not there already. The file is replaced in one step. Returns how many were
/// added. \throws InputError as read_worst, and when the file cannot be written
std::size_t merge_worst(const std::filesystem::path& path, const std::vector<WorstLine>& cases, std::size_t few);

}  // namespace cageproof::reports
