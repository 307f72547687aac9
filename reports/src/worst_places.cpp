// SPDX-License-Identifier: MIT
#include "worst_places.h"

#include "cageproof/reports/packed_file.h"
#include "cageproof/reports/worst_file.h"
#include "figure.h"

#include <fmt/format.h>

#include <algorithm>

namespace cageproof::reports {
namespace {

std::string file_of(const ResultRow& row) {
  const RowHome home = home_of(row);
  return fmt::format("worst/{}{}.jsonl.gz", home.prefix, file_name(home.name));
}

// There are many rows of kept promises, and readers ask only for the worst input of each.
std::size_t count_of(const ResultRow& row) {
  return row.verdict == Verdict::Broken ? row.worst.size() : std::min<std::size_t>(row.worst.size(), 1);
}

}  // namespace

RowHome home_of(const RowKey& row) {
  switch (row.section) {
    case RowKey::Section::Element: return {"formulas", "", row.subject};
    case RowKey::Section::Cage: return {"cages", "cage.", row.setting};
    case RowKey::Section::Deformer: break;
  }
  return {"deformers", "deformer.", row.setting};
}

WorstPlaces::WorstPlaces(const RunResult& result) {
  std::map<std::string, std::size_t> next;
  for (const ResultRow& row : result.rows) {
    const WorstPlace place{file_of(row), 1 + next[file_of(row)], count_of(row)};
    next[place.file] += place.count;
    places_[&row] = place;
  }
}

std::map<std::string, std::string> worst_files(const RunResult& result) {
  std::map<std::string, std::string> files{{"worst.jsonl", ""}};
  for (const ResultRow& row : result.rows) {
    std::string lines;
    for (std::size_t i = 0; i < count_of(row); ++i)
      lines += worst_line(worst_line_of(row, row.worst[i], result)) + "\n";
    if (row.verdict == Verdict::Broken) files["worst.jsonl"] += lines;
    if (!lines.empty()) files[file_of(row)] += lines;
  }
  for (auto& [name, lines] : files)
    if (name.ends_with(".gz")) lines = packed(lines);
  return files;
}

}  // namespace cageproof::reports
