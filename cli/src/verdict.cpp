// SPDX-License-Identifier: MIT
#include "commands.h"

#include "cageproof/reports/broken_groups.h"
#include "cageproof/validation/stored_cases.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

namespace cageproof::cli {
namespace {

// The report has them all.
constexpr std::size_t most_rows_shown = 4;

void print_row(const ResultRow& row) {
  std::string names;
  // Deformers with their defaults have no evaluation, single elements no place.
  for (const std::string& name : {row.subject, row.evaluation, row.scalar, row.setting, row.place, row.check})
    if (!name.empty()) names += name + ' ';
  fmt::print("  {} {}order {}: {}\n", row.verdict == Verdict::Undecided ? "undecided" : "BROKEN", names, row.order,
             reports::breach(row));
}

void print_rows(const std::vector<const ResultRow*>& rows) {
  const std::size_t shown = std::min(rows.size(), most_rows_shown);
  for (std::size_t i = 0; i < shown; ++i) print_row(*rows[i]);
  if (shown < rows.size()) fmt::print("  and {} more\n", rows.size() - shown);
}

void print_group(const reports::BrokenGroup& group) {
  fmt::print("{}\n", reports::title_of(group));
  print_rows(group.rows);
  if (!group.simplest) return;
  const ResultRow& row = *group.simplest_row;
  const std::string origin = row.section == RowKey::Section::Element ? validation::origin_of(row, *group.simplest) : "";
  fmt::print("  simplest: {} order {}, {}: {}\n", row.subject, row.order, origin.empty() ? row.setting : origin,
             reports::error_line(row, *group.simplest));
}

}  // namespace

ExitCode print_verdict(const RunResult& result, const std::string& out) {
  const std::filesystem::path folder = out;
  std::size_t kept = 0, broken = 0, unpromised = 0;
  std::vector<const ResultRow*> undecided;
  for (const ResultRow& row : result.rows) {
    kept += row.verdict == Verdict::Kept;
    broken += row.verdict == Verdict::Broken;
    unpromised += row.verdict == Verdict::NotPromised;
    if (row.verdict == Verdict::Undecided) undecided.push_back(&row);
  }
  for (const reports::BrokenGroup& group : reports::broken_groups(result)) print_group(group);
  print_rows(undecided);
  fmt::print("{}: {} promises kept, {} broken, {} rows not promised{}\n",
             broken != 0          ? "PROMISES BROKEN"
             : !undecided.empty() ? "no promise broken"
                                  : "all promises kept",
             kept, broken, unpromised,
             undecided.empty() ? "" : fmt::format(", {} undecided: more --samples would decide", undecided.size()));
  fmt::print("report: {}\n", (folder / "index.html").string());
  if (broken != 0) fmt::print("worst inputs: cageproof replay {}\n", (folder / "worst.jsonl").string());
  for (const std::string& note : result.session_notes) fmt::print(stderr, "cageproof: {}\n", note);
  return broken == 0 ? success : promise_broken;
}

}  // namespace cageproof::cli
