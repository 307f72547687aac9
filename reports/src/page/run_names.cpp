// SPDX-License-Identifier: MIT
#include "run_names.h"

namespace cageproof::reports {

ShownNames names_of_run(const RunResult& result) {
  std::vector<std::string> names;
  for (const ResultRow& row : result.rows)
    if (row.section != RowKey::Section::Element && (names.empty() || names.back() != row.setting))
      names.push_back(row.setting);
  for (const char* setting : {"cage", "points"})
    if (const auto given = result.settings.find(setting); given != result.settings.end())
      names.push_back(given->second);
  return ShownNames(names);
}

}  // namespace cageproof::reports
