// SPDX-License-Identifier: MIT
#include "cageproof/reports/checked_file.h"
#include "cageproof/core/whole_file.h"
#include "cageproof/reports/worst_file.h"

#include <algorithm>
#include <map>

namespace cageproof::reports {
std::size_t merge_worst(const std::filesystem::path& path, const std::vector<WorstLine>& cases, std::size_t few) {
  std::error_code missing;
  std::string text = std::filesystem::exists(path, missing) ? read_file(path) : std::string();
  std::map<RowKey, std::vector<WorstLine>> known;
  for (const WorstLine& line : parse_worst(text, path.string())) known[line].push_back(line);
  std::vector<WorstLine> fresh = cases;
  std::ranges::stable_sort(fresh, [](const WorstLine& a, const WorstLine& b) { return a.worst.error > b.worst.error; });
  if (!text.empty() && text.back() != '\n') text += '\n';
  std::size_t added = 0;
  for (const WorstLine& line : fresh) {
    auto& same = known[line];
    const auto worse =
        std::ranges::count_if(same, [&](const WorstLine& other) { return other.worst.error >= line.worst.error; });
    const bool there = std::ranges::any_of(
        same, [&](const WorstLine& other) { return input_bits(other.worst) == input_bits(line.worst); });
    if (there || static_cast<std::size_t>(worse) >= few) continue;
    same.push_back(line);
    text += worst_line(line) + "\n";
    ++added;
  }
  if (added > 0) replace_file(path, text);
  return added;
}

}  // namespace cageproof::reports
