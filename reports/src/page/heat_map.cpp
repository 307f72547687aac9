// SPDX-License-Identifier: MIT
// Formulas by regimes: how many digits of values are right at the worst input, in the evaluation that is recommended.
// The first thing that a reader sees below the verdict. Each cell leads to its line of the overview.
#include "check_words.h"
#include "figure.h"
#include "page_data.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace cageproof::reports {
namespace {

// The worst input's digits, as figure_text has them.
double digits_right(const ResultRow& row) {
  const double relative = std::isfinite(row.max) ? row.max_relative : row.max;
  return std::isfinite(relative) ? -std::log10(relative) : 0;
}

Data heat_cell(const ResultRow* row, bool any, std::size_t line) {
  Data data;
  data.set("any", any);
  data.set("class", row ? heat_class(*row) : "");
  data.set("text", row ? heat_text(*row) : "·");
  data.set("line", fmt::format("{}", line));
  return data;
}

}  // namespace

std::string heat_text(const ResultRow& row) {
  if (row.samples == 0) return row.verdict == Verdict::Broken ? "– ✗" : "–";
  return digits_kept(std::isfinite(row.max) ? row.max_relative : row.max, row.scalar) +
         (row.verdict == Verdict::Broken ? " ✗" : "");
}

std::string heat_class(const ResultRow& row) {
  std::string looks = cell_class(row);
  if (looks == "ill") return looks;
  const double digits = row.samples == 0 ? 0 : digits_right(row);
  // The same steps as heatClass of page.js.
  const char* colour = digits >= 12 ? "e0" : digits >= 8 ? "e1" : digits >= 4 ? "e2" : digits >= 1 ? "e3" : "e4";
  // After the colour comes a broken promise's frame, or the hatching of cells without promises.
  const auto rest = looks.find(' ');
  return rest == looks.npos ? colour : colour + looks.substr(rest);
}

void set_heat_map(Data& page, const RunResult& result) {
  std::vector<std::string> regimes;
  std::vector<std::pair<std::string, ErrorTable>> tables;
  for (const std::string& formula : subjects(result, ResultRow::Section::Element)) {
    ErrorTable table = truth_table(result, formula);
    if (table.columns.empty()) continue;
    for (const std::string& regime : table.regimes)
      if (std::ranges::find(regimes, regime) == regimes.end()) regimes.push_back(regime);
    tables.emplace_back(formula, std::move(table));
  }
  // Regimes that the recommended evaluation was not asked for are hidden: a script shows them when
  // another is chosen.
  const auto is_shown = [&](const std::string& regime) {
    return std::ranges::any_of(
        tables, [&](const auto& one) { return one.second.at(regime, one.second.columns.front(), 0) != nullptr; });
  };
  Data heads{Data::type::list}, lines{Data::type::list};
  std::vector<bool> hidden;
  for (const std::string& regime : regimes) {
    hidden.push_back(!is_shown(regime));
    Data head;
    head.set("name", regime);
    head.set("hidden", static_cast<bool>(hidden.back()));
    heads << head;
  }
  // Lines of the overview are counted on as they stand there: by formula, then by regime.
  std::size_t first = 0;
  for (const auto& [formula, table] : tables) {
    Data line, cells{Data::type::list};
    for (std::size_t r = 0; r < regimes.size(); ++r) {
      const std::string& regime = regimes[r];
      const auto place = std::ranges::find(table.regimes, regime);
      const bool any = place != table.regimes.end();
      Data cell = heat_cell(any ? table.at(regime, table.columns.front(), 0) : nullptr, any,
                            first + static_cast<std::size_t>(place - table.regimes.begin()));
      cell.set("hidden", static_cast<bool>(hidden[r]));
      cells << cell;
    }
    first += table.regimes.size();
    line.set("formula", breakable(formula));
    line.set("cells", cells);
    lines << line;
  }
  page.set("heat_heads", heads);
  set_list(page, "heat", lines);
}

}  // namespace cageproof::reports
