// SPDX-License-Identifier: MIT
#include "digest.h"

#include "cageproof/core/catalogue/formula.h"
#include "cageproof/core/catalogue/role.h"
#include "figure.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <cmath>
#include <limits>
#include <map>
#include <tuple>

namespace cageproof::reports {

using Section = ResultRow::Section;

const ResultRow* ErrorTable::at(const std::string& regime, const Column& column, int order) const {
  for (const ResultRow* row : rows)
    if (row->order == order && row->setting == regime && row->evaluation == column.evaluation &&
        row->scalar == column.scalar)
      return row;
  return nullptr;
}

std::string role_of(const RunResult& result, const std::string& formula, const std::string& evaluation) {
  const auto row = std::ranges::find_if(result.rows, [&](const ResultRow& r) {
    return r.section == Section::Element && r.evaluation == evaluation && r.subject == formula;
  });
  return row == result.rows.end() ? std::string() : row->role;
}

std::string verdict_line(const RunResult& result) {
  const auto count = [&](Verdict verdict) {
    return static_cast<std::uint64_t>(std::ranges::count(result.rows, verdict, &ResultRow::verdict));
  };
  const std::uint64_t broken = count(Verdict::Broken), promised = broken + count(Verdict::Kept),
                      undecided = count(Verdict::Undecided);
  const std::string open =
      undecided == 0 ? ""
                     : fmt::format("; {} {} undecided", grouped(undecided), undecided == 1 ? "row is" : "rows are");
  if (promised == 0) return "Nothing was promised in this run" + open;
  if (broken == 0)
    return (promised == 1 ? "The one promise is kept" : fmt::format("All {} promises kept", grouped(promised))) + open;
  return fmt::format("{} of {} promises broken", grouped(broken), grouped(promised)) + open;
}

double strain(const ResultRow& row) {
  if (!row.bound) return row.max;
  if (*row.bound > 0) return row.max / *row.bound;
  return row.max > 0 ? std::numeric_limits<double>::infinity() : 0;
}

Rows broken_rows(const RunResult& result) {
  Rows rows;
  for (const ResultRow& row : result.rows)
    if (row.verdict == Verdict::Broken) rows.push_back(&row);
  std::ranges::stable_sort(rows, std::greater(),
                           [](const ResultRow* row) { return std::pair(row->is_foundation, strain(*row)); });
  return rows;
}

std::vector<std::string> subjects(const RunResult& result, Section section) {
  Rows rows;
  for (const ResultRow& row : result.rows)
    if (row.section == section) rows.push_back(&row);
  std::vector<std::string> names =
      distinct(rows, [](const ResultRow* row) -> const std::string& { return row->subject; });
  std::ranges::stable_sort(names, {}, [](const std::string& name) { return rank_of(name); });
  return names;
}

ErrorTable truth_table(const RunResult& result, const std::string& subject) {
  ErrorTable table;
  for (const ResultRow& row : result.rows) {
    if (row.section != Section::Element || row.subject != subject || row.check != "truth") continue;
    table.rows.push_back(&row);
    const Column column{row.evaluation, row.scalar};
    if (std::ranges::find(table.columns, column) == table.columns.end()) table.columns.push_back(column);
  }
  table.regimes = distinct(table.rows, [](const ResultRow* row) -> const std::string& { return row->setting; });
  // The evaluations that users run come first.
  std::ranges::stable_partition(table.columns, [&](const Column& column) {
    return column.scalar == "double" && role_of(result, subject, column.evaluation) == name_of(Role::Recommended);
  });
  return table;
}

std::string figure_text(const ResultRow& row) {
  if (row.check != "truth") return short_error(row.max);
  const double relative = std::isfinite(row.max) ? row.max_relative : row.max;
  return fmt::format("{} ({})", digits_kept(relative, row.scalar), short_error(row.max));
}

// Broken before kept, promised before not, then by how far it goes.
bool more_telling(const ResultRow& a, const ResultRow& b) {
  const auto key = [](const ResultRow& row) {
    return std::tuple(row.verdict == Verdict::Broken, row.bound.has_value(), strain(row));
  };
  return key(a) > key(b);
}

Rows tightest_properties(const RunResult& result, const std::string& subject) {
  std::map<std::tuple<std::string, std::string, std::string, int, std::string>, std::size_t> seen;
  Rows rows;
  for (const ResultRow& row : result.rows) {
    if (row.section != Section::Element || row.subject != subject || row.check == "truth") continue;
    const auto [at, fresh] =
        seen.try_emplace({row.check, row.evaluation, row.scalar, row.order, row.unit}, rows.size());
    if (fresh) rows.push_back(&row);
    else if (more_telling(row, *rows[at->second])) rows[at->second] = &row;
  }
  return rows;
}

namespace {

using Label = std::string (*)(const ResultRow& row);

CageTable table_of(const RunResult& result, Section section, Label line, Label column) {
  CageTable table;
  std::map<std::tuple<std::string, std::string, std::string>, std::size_t> line_of;
  for (const ResultRow& row : result.rows)
    if (row.section == section && std::ranges::find(table.columns, column(row)) == table.columns.end())
      table.columns.push_back(column(row));
  for (const ResultRow& row : result.rows) {
    if (row.section != section) continue;
    const auto [at, fresh] = line_of.try_emplace({row.setting, line(row), row.unit}, table.lines.size());
    if (fresh) table.lines.push_back({row.setting, line(row), row.unit, Rows(table.columns.size())});
    const std::size_t place = std::ranges::find(table.columns, column(row)) - table.columns.begin();
    const ResultRow*& cell = table.lines[at->second].cells[place];
    if (!cell || more_telling(row, *cell)) cell = &row;
  }
  // A cage's lines together, whatever order its checks ran in.
  const auto names = distinct(table.lines, [](const CageTable::Line& l) -> const std::string& { return l.cage; });
  std::ranges::stable_sort(table.lines, {}, [&](const CageTable::Line& l) { return std::ranges::find(names, l.cage); });
  return table;
}

std::string check_of(const ResultRow& row) { return row.check; }
std::string coordinates_of(const ResultRow& row) { return row.subject + ", " + row.evaluation + ", " + row.scalar; }
std::string deformer_of(const ResultRow& row) {
  return row.evaluation.empty() ? row.subject : row.subject + ", " + row.evaluation;
}

}  // namespace

CageTable cage_table(const RunResult& result) { return table_of(result, Section::Cage, check_of, coordinates_of); }

CageTable deformer_table(const RunResult& result) { return table_of(result, Section::Deformer, deformer_of, check_of); }

}  // namespace cageproof::reports
