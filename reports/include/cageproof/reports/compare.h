// SPDX-License-Identifier: MIT
// Two reports side by side: which figures and verdicts differ.
#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace cageproof::reports {

/// Old names and their successors, for formulas, kinds, evaluations, checks and regimes. "closed_form" renames wherever
/// the name stands; "quad.mean_value/closed_form" renames only in rows of that (old) subject, and goes before the
/// other.
using Renamed = std::map<std::string, std::string>;

/// Reads a JSON object of strings.
/// \throws InputError naming the file when it is anything else
Renamed read_renamed(const std::filesystem::path& path);

struct Differences {
  std::size_t equal = 0;               ///< rows, curves, fields and errata with the same figures and verdicts
  std::vector<std::string> differing;  ///< a line each: what, and every figure that differs as "old -> new"
  std::vector<std::string> gone;       ///< entries only in the old report, one line each
  std::vector<std::string> added;      ///< entries only in the new report, one line each
  /// Entries `closed_form` of a schema before 4 that were compared with `hybrid`, their name today.
  std::size_t taken_for_hybrid = 0;
  std::vector<std::string> settings;  ///< of the runs that differ, each as "name old -> new"
  bool same() const { return differing.empty() && gone.empty() && added.empty(); }
};

/// Compares two texts of summary.json, of this program or an earlier one. Matched by section, subject, evaluation,
/// scalar, regime, check, place and order; order in the file, reasons, worst inputs, file names and environments are
/// not looked at. Numbers must be equal as doubles. \param old_name, new_name what messages call them \throws
/// InputError for text that is no such summary, of a later schema, or whose histograms have other bins
Differences compare_summaries(std::string_view old_text, std::string_view new_text, const Renamed& renamed,
                              std::string_view old_name = "the old report",
                              std::string_view new_name = "the new report");

}  // namespace cageproof::reports
