// SPDX-License-Identifier: MIT
// The rows of two summaries, matched by their subjects.
#pragma once

#include "cageproof/reports/compare.h"
#include "json_value.h"

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace cageproof::reports {

/// Two summaries, and their rows by name, which point into `before` and `after`.
struct MatchedRows {
  Json before, after;
  std::map<std::string, const Json*> old_rows, new_rows;
  std::size_t taken_for_hybrid = 0;  ///< as Differences has it

  /// \throws InputError as compare_summaries, except that bins of histograms may differ
  MatchedRows(std::string_view old_text, std::string_view new_text, const Renamed& renamed, std::string_view old_name,
              std::string_view new_name);
  MatchedRows(const MatchedRows&) = delete;
  MatchedRows& operator=(const MatchedRows&) = delete;
};

/// Options of two runs that decide their figures, and differ: one text each, "name old -> new".
std::vector<std::string> differing_settings(const Json& before, const Json& after);

}  // namespace cageproof::reports
