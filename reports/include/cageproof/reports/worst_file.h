// SPDX-License-Identifier: MIT
// worst.jsonl: the worst inputs of a run, exactly, one JSON object a line.
#pragma once

#include "cageproof/core/run_result.h"

#include <filesystem>

namespace cageproof::reports {

/// One line: a worst case and the row it belongs to.
struct WorstLine {
  ResultRow::Section section = ResultRow::Section::Element;
  std::string subject;  ///< formula, or kind of cage coordinates
  std::string evaluation;
  std::string scalar;
  std::string regime;  ///< for a cage its name
  std::string check;
  std::string place;  ///< empty but for a cage
  int order = 0;      ///< 0 value, 1 gradient, 2 Hessian
  std::string unit;   ///< of error and bound
  std::optional<double> bound;
  std::vector<std::string> flags;  ///< what the input exercises: the regime, or the place
  std::string triangulation;       ///< RunResult::settings["triangulation"], or empty
  WorstCase worst;                 ///< corners, point and parameters bit for bit
};

/// The lines of all rows that have worst cases, in the order of the rows: keys formula (kind for a cage), evaluation,
/// scalar, regime, check, place, order, unit, error, bound, parameter, sample, flags, element, point, parameters,
/// triangulation. Coordinates and parameters are hexadecimal floats in strings; infinite errors the string "inf".
std::string worst_lines(const RunResult& result);

/// Reads a worst.jsonl; blank lines are skipped, unknown keys ignored.
/// \throws InputError naming file and line: missing or empty file, malformed JSON, missing key, wrong type, bad number
std::vector<WorstLine> read_worst(const std::filesystem::path& path);

}  // namespace cageproof::reports
