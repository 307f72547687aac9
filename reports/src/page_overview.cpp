// SPDX-License-Identifier: MIT
#include "page_data.h"

#include <algorithm>

namespace cageproof::reports {
void set_overview(Data& page, const RunResult& result) {
  const std::vector<std::string> names = subjects(result, ResultRow::Section::Element);
  std::vector<ErrorTable> tables;
  std::vector<std::string> regimes;
  Column lead{"closed_form", "double"};
  for (const std::string& name : names) {
    tables.push_back(truth_table(result, name));
    for (const std::string& regime : tables.back().regimes)
      if (std::ranges::find(regimes, regime) == regimes.end()) regimes.push_back(regime);
  }
  // A run without the closed form in double shows what it has.
  const auto has_lead = [&](const ErrorTable& table) {
    return std::ranges::find(table.columns, lead) != table.columns.end();
  };
  const auto any = std::ranges::find_if(tables, [](const ErrorTable& table) { return !table.columns.empty(); });
  if (any != tables.end() && std::ranges::none_of(tables, has_lead)) lead = any->columns.front();
  Data heads{Data::type::list}, lines{Data::type::list};
  for (const std::string& regime : regimes) heads << Data(regime);
  for (std::size_t f = 0; f < names.size(); ++f) {
    if (!has_lead(tables[f])) continue;
    Data line, cells{Data::type::list};
    line.set("name", names[f]);
    line.set("anchor", anchor("formula", names[f]));
    for (const std::string& regime : regimes) {
      Data cell, orders{Data::type::list};
      for (int order = 0; order < 3; ++order) orders << error_cell(tables[f].at(regime, lead, order));
      cell.set("orders", orders);
      cells << cell;
    }
    line.set("cells", cells);
    lines << line;
  }
  page.set("overview_heads", heads);
  page.set("overview_of", lead.evaluation + " in " + lead.scalar);
  set_list(page, "overview", lines);
}

}  // namespace cageproof::reports
