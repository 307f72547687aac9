// SPDX-License-Identifier: MIT
#include "page_data.h"

#include <algorithm>
#include <optional>

namespace cageproof::reports {
void set_overview(Data& page, const RunResult& result) {
  const std::vector<std::string> names = subjects(result, ResultRow::Section::Element);
  std::vector<ErrorTable> tables;
  std::vector<std::string> regimes;
  for (const std::string& name : names) {
    tables.push_back(truth_table(result, name));
    for (const std::string& regime : tables.back().regimes)
      if (std::ranges::find(regimes, regime) == regimes.end()) regimes.push_back(regime);
  }
  // Each formula's own; in a run without recommended evaluations in double, the first column that there is.
  std::vector<std::optional<Column>> leads(names.size());
  std::string shown = "the recommended evaluations in double";
  for (std::size_t f = 0; f < names.size(); ++f)
    if (const auto& columns = tables[f].columns;
        !columns.empty() && columns.front().scalar == "double" && is_recommended(names[f], columns.front().evaluation))
      leads[f] = columns.front();
  const auto any = std::ranges::find_if(tables, [](const ErrorTable& table) { return !table.columns.empty(); });
  if (any != tables.end() && std::ranges::none_of(leads, [](const auto& lead) { return lead.has_value(); })) {
    const Column& first = any->columns.front();
    shown = first.evaluation + " in " + first.scalar;
    for (std::size_t f = 0; f < names.size(); ++f)
      if (std::ranges::find(tables[f].columns, first) != tables[f].columns.end()) leads[f] = first;
  }
  Data heads{Data::type::list}, lines{Data::type::list};
  for (const std::string& regime : regimes) heads << Data(regime);
  for (std::size_t f = 0; f < names.size(); ++f) {
    if (!leads[f]) continue;
    Data line, cells{Data::type::list};
    line.set("name", names[f]);
    line.set("anchor", anchor("formula", names[f]));
    for (const std::string& regime : regimes) {
      Data cell, orders{Data::type::list};
      for (int order = 0; order < 3; ++order) orders << error_cell(tables[f].at(regime, *leads[f], order));
      cell.set("orders", orders);
      cells << cell;
    }
    line.set("cells", cells);
    lines << line;
  }
  page.set("overview_heads", heads);
  page.set("overview_of", shown);
  set_list(page, "overview", lines);
}

}  // namespace cageproof::reports
