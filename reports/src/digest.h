// SPDX-License-Identifier: MIT
// The rows of a run in the order people read them: shared by the Markdown summary and the page.
#pragma once

#include "cageproof/core/results/run_result.h"

#include <algorithm>
#include <compare>
#include <string>
#include <vector>

namespace cageproof::reports {

/// An evaluation in a scalar: a column of a table.
struct Column {
  std::string evaluation, scalar;
  auto operator<=>(const Column&) const = default;
};

/// The rows of one check of one subject: regimes down, columns across.
struct ErrorTable {
  std::vector<std::string> regimes;
  std::vector<Column> columns;
  std::vector<const ResultRow*> rows;
  /// Null where there is none.
  const ResultRow* at(const std::string& regime, const Column& column, int order) const;
};

/// The role of a formula's evaluation, as its rows have it; empty where there is none. What users run, the recommended
/// one, every table and picture shows first.
std::string role_of(const RunResult& result, const std::string& formula, const std::string& evaluation);

using Rows = std::vector<const ResultRow*>;

/// "all promises kept", or how many are broken, or that nothing was promised.
std::string verdict_line(const RunResult& result);

/// The broken rows: foundations of others first, then the one furthest beyond its bound.
Rows broken_rows(const RunResult& result);

/// The subjects of a section that have rows: formulas in the catalogue's order, then others as they come.
std::vector<std::string> subjects(const RunResult& result, ResultRow::Section section);

/// The rows of a subject's check against the truth.
ErrorTable truth_table(const RunResult& result, const std::string& subject);

/// Text of a row's error. For errors against the truth the number of right digits at the worst input, whatever the
/// conditioning, comes first: "14.8 (2.5)"; for other checks it is only the error, "2.5".
std::string figure_text(const ResultRow& row);

/// One line per (check, evaluation, scalar, order, unit) of a subject, without the truth: the row that comes nearest to
/// its bound or goes furthest beyond it, over all regimes.
Rows tightest_properties(const RunResult& result, const std::string& subject);

/// Table of the checks on cages. Each cell is the worst row of all places and orders, or null.
struct CageTable {
  struct Line {
    std::string cage, name, unit;
    Rows cells;
  };
  std::vector<std::string> columns;
  std::vector<Line> lines;
};

/// The cages' properties: a line a (cage, check, unit), a column a (kind, evaluation, scalar).
CageTable cage_table(const RunResult& result);

/// Table of the checks of deformers, by (cage, deformer with variant, unit) down and by checks across.
CageTable deformer_table(const RunResult& result);

/// max / bound; without a bound, max. What is worst in one table is largest.
double strain(const ResultRow& row);

/// Whether row a must be shown rather than b where there is room for one: broken before kept, promised before not
/// promised, then by strain.
bool more_telling(const ResultRow& a, const ResultRow& b);

/// The distinct values of a member, in the order of first appearance.
template <class Range, class Projection>
std::vector<std::string> distinct(const Range& range, Projection projection) {
  std::vector<std::string> values;
  for (const auto& item : range) {
    const std::string& value = projection(item);
    if (std::find(values.begin(), values.end(), value) == values.end()) values.push_back(value);
  }
  return values;
}

}  // namespace cageproof::reports
