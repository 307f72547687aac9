// SPDX-License-Identifier: MIT
// One line per formula and regime. It shows the recommended evaluation; a script can show each of the others,
// from numbers that the page holds.
#include "check_words.h"
#include "figure.h"
#include "json_value.h"
#include "page_data.h"
#include "script_json.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

namespace cageproof::reports {
namespace {

// The column that the lines show without a script: the first one, as a rule the recommended evaluation in double.
Column lead_of(const ErrorTable& table) { return table.columns.front(); }

std::string name_of(const Column& column) { return column.evaluation + ", " + column.scalar; }

Data line_of(const std::string& formula, const std::string& regime, const ErrorTable& table, std::size_t number) {
  const Column lead = lead_of(table);
  Data line, orders{Data::type::list};
  const ResultRow* telling = nullptr;
  for (int order = 0; order < 3; ++order) {
    const ResultRow* row = table.at(regime, lead, order);
    orders << error_cell(row, "index.html");
    if (row && (!telling || more_telling(*row, *telling))) telling = row;
  }
  line.set("line", fmt::format("{}", number));
  line.set("hidden", telling == nullptr);
  line.set("formula", breakable(formula));
  line.set("page", fmt::format("formulas/{}.html", file_name(formula)));
  line.set("regime", regime);
  line.set("evaluation", name_of(lead));
  line.set("orders", orders);
  line.set("bound", telling && telling->bound ? short_number(*telling->bound) : "");
  line.set("samples", telling ? grouped(telling->samples) : "");
  return line;
}

// Cells of every evaluation, by the number of its column: text and class of each order.
Json cells_of(const ErrorTable& table, const std::string& regime, const std::vector<std::string>& evaluations) {
  Json cells = Json::object();
  for (const Column& column : table.columns) {
    Json orders = Json::array();
    bool any = false;
    for (int order = 0; order < 3; ++order) {
      const ResultRow* row = table.at(regime, column, order);
      any = any || row;
      orders.push_back(Json::array());
      if (!row) continue;
      orders.back() = {cell_text(*row), cell_class(*row)};
      // The script makes the usual id itself; one where names have characters that ids have not is told.
      const std::string usual = fmt::format("truth.{}.{}.{}.{}", regime, column.evaluation, column.scalar, order);
      if (const std::string id = cell_id(*row); id != usual) orders.back().push_back(id);
    }
    const auto number = std::ranges::find(evaluations, name_of(column)) - evaluations.begin();
    if (any) cells[fmt::format("{}", number)] = std::move(orders);
  }
  return cells;
}

}  // namespace

void set_overview(Data& page, const RunResult& result) {
  Data lines{Data::type::list};
  std::vector<std::string> evaluations;
  Json cells = Json::array();
  for (const std::string& formula : subjects(result, ResultRow::Section::Element)) {
    const ErrorTable table = truth_table(result, formula);
    if (table.columns.empty()) continue;
    for (const Column& column : table.columns)
      if (std::ranges::find(evaluations, name_of(column)) == evaluations.end()) evaluations.push_back(name_of(column));
    for (const std::string& regime : table.regimes) {
      lines << line_of(formula, regime, table, cells.size());
      cells.push_back(cells_of(table, regime, evaluations));
    }
  }
  set_list(page, "overview", lines);
  page.set("overview_json", script_json({{"evaluations", evaluations}, {"cells", cells}}));
}

}  // namespace cageproof::reports
