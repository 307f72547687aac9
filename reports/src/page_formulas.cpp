// SPDX-License-Identifier: MIT
#include "cageproof/core/formula.h"
#include "figure.h"
#include "page_data.h"

#include <fmt/format.h>

#include <algorithm>

namespace cageproof::reports {
namespace {

Data truth_lines(const ErrorTable& table) {
  Data lines{Data::type::list};
  for (const std::string& regime : table.regimes) {
    Data line, cells{Data::type::list};
    line.set("regime", regime);
    for (const Column& column : table.columns)
      for (int order = 0; order < 3; ++order) {
        Data cell = error_cell(table.at(regime, column, order));
        cell.set("first", order == 0);
        cells << cell;
      }
    line.set("digits_lost", lead_digits_lost(table, regime));
    line.set("cells", cells);
    lines << line;
  }
  return lines;
}

Data detail(const ResultRow& row) {
  Data line;
  line.set("regime", row.regime);
  line.set("check", row.check);
  line.set("evaluation", row.evaluation + ", " + row.scalar);
  line.set("order", std::string(order_name(row.order)));
  line.set("cell", error_cell(&row));
  line.set("unit", row.unit);
  line.set("p999", short_error(row.p999));
  line.set("median", short_error(row.median));
  line.set("relative", short_error(row.max_relative));
  line.set("samples", grouped(row.samples));
  line.set("nonfinite", grouped(row.nonfinite));
  line.set("without_truth", grouped(row.without_truth));
  line.set("declined", grouped(row.declined));
  line.set("bound", row.bound ? short_number(*row.bound) : "");
  line.set("verdict", std::string(name_of(row.verdict)));
  line.set("reason", row.reason);
  return line;
}

// "closed_form, double: 3.2 · 4.1 · 12" and the row that is worst of them, or null.
std::pair<std::string, const ResultRow*> lead_figures(const ErrorTable& table, const std::string& regime) {
  if (table.columns.empty()) return {"", nullptr};
  const Column& lead = table.columns.front();
  std::string text;
  const ResultRow* worst = nullptr;
  for (int order = 0; order < 3; ++order) {
    const ResultRow* row = table.at(regime, lead, order);
    if (!row) continue;
    text += (text.empty() ? "" : " · ") + short_error(row->max);
    if (!worst || more_telling(*row, *worst)) worst = row;
  }
  return {text.empty() ? "" : fmt::format("{}, {}: {}", lead.evaluation, lead.scalar, text), worst};
}

Data pictures(const ErrorTable& table, const std::string& subject, const std::vector<CurvePicture>& curves,
              const std::filesystem::path& folder) {
  // The regime that tells most is open when the page opens.
  const ResultRow* telling = nullptr;
  const std::string* open = nullptr;
  for (const CurvePicture& curve : curves) {
    if (curve.subject != subject) continue;
    const ResultRow* row = lead_figures(table, curve.regime).second;
    if (!open || (row && (!telling || more_telling(*row, *telling)))) open = &curve.regime, telling = row;
  }
  Data list{Data::type::list};
  for (const CurvePicture& curve : curves) {
    if (curve.subject != subject) continue;
    Data data;
    const std::string figures = curve.check == "truth" ? lead_figures(table, curve.regime).first : "";
    data.set("regime", curve.regime);
    data.set("check", curve.check == "truth" ? "" : ", " + curve.check);
    data.set("figures", figures);
    data.set("open", curve.regime == *open && curve.check == "truth");
    data.set("file", curve.picture.file);
    data.set("width", fmt::format("{}", curve.picture.width));
    data.set("height", fmt::format("{}", curve.picture.height));
    data.set("picture", embedded_png(folder / curve.picture.file));
    data.set("alt",
             fmt::format("{} in regime {}: largest conditioned error against {}, for value, gradient and Hessian, one "
                         "curve an evaluation. {}",
                         subject, curve.regime, curve.parameter_name, figures));
    list << data;
  }
  return list;
}

}  // namespace

void set_formulas(Data& page, const RunResult& result, const std::vector<CurvePicture>& curves,
                  const std::filesystem::path& folder) {
  Data formulas{Data::type::list};
  for (const std::string& subject : subjects(result, ResultRow::Section::Element)) {
    const ErrorTable table = truth_table(result, subject);
    const Formula* formula = find_formula(subject);
    Data data;
    data.set("name", subject);
    data.set("anchor", anchor("formula", subject));
    data.set("known", formula != nullptr);
    if (formula) {
      data.set("symbol", std::string(formula->symbol));
      data.set("definition", std::string(formula->definition));
      data.set("source", std::string(formula->source));
      data.set("element", std::string(name_of(formula->element)));
    }
    Data columns{Data::type::list}, details{Data::type::list}, properties{Data::type::list};
    for (const Column& column : table.columns) columns << Data(column.evaluation + ", " + column.scalar);
    for (const ResultRow* row : table.rows) details << detail(*row);
    for (const ResultRow* row : tightest_properties(result, subject)) properties << detail(*row);
    data.set("columns", columns);
    data.set("truth", truth_lines(table));
    data.set("has_truth", !table.rows.empty());
    data.set("details", details);
    set_list(data, "properties", properties);
    set_list(data, "pictures", pictures(table, subject, curves, folder));
    formulas << data;
  }
  set_list(page, "formulas", formulas);
}

}  // namespace cageproof::reports
