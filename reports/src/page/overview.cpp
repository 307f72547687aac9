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

// What the script shows of other evaluations, whose columns it numbers.
struct OtherCells {
  std::vector<std::string> evaluations;
  Json lines = Json::array();  ///< of each line, by the column's number: text and class of each order
  Json ids = Json::object();   ///< by regime and the column's number: each order's id, the same on all formulas' pages

  void add_line(const ErrorTable& table, const std::string& regime);
};

void OtherCells::add_line(const ErrorTable& table, const std::string& regime) {
  Json& line = lines.emplace_back(Json::object());
  for (const Column& column : table.columns) {
    const auto place = std::ranges::find(evaluations, name_of(column)) - evaluations.begin();
    const std::string number = fmt::format("{}", place);
    for (int order = 0; order < 3; ++order) {
      const ResultRow* row = table.at(regime, column, order);
      if (!row) continue;
      if (!line.contains(number)) line[number] = Json::array({Json::array(), Json::array(), Json::array()});
      line[number][order] = {cell_text(*row), cell_class(*row)};
      Json& id = ids[regime][number];
      if (id.is_null()) id = {"", "", ""};
      id[order] = cell_id(*row);
    }
  }
}

}  // namespace

void set_overview(Data& page, const RunResult& result) {
  Data lines{Data::type::list};
  OtherCells cells;
  for (const std::string& formula : subjects(result, ResultRow::Section::Element)) {
    const ErrorTable table = truth_table(result, formula);
    if (table.columns.empty()) continue;
    for (const Column& column : table.columns)
      if (std::ranges::find(cells.evaluations, name_of(column)) == cells.evaluations.end())
        cells.evaluations.push_back(name_of(column));
    for (const std::string& regime : table.regimes) {
      lines << line_of(formula, regime, table, cells.lines.size());
      cells.add_line(table, regime);
    }
  }
  set_list(page, "overview", lines);
  page.set("overview_json",
           script_json({{"evaluations", cells.evaluations}, {"cells", cells.lines}, {"ids", cells.ids}}));
}

}  // namespace cageproof::reports
