// SPDX-License-Identifier: MIT
// Which rows people read first, and which stands where there is room for one.
#include "digest.h"

#include <gtest/gtest.h>

#include <cmath>

namespace cageproof::reports {
namespace {

ResultRow measured(const char* check, const char* regime, double error, std::optional<double> bound) {
  ResultRow row;
  row.subject = "triangle.single_layer";
  row.evaluation = "closed_form";
  row.scalar = "double";
  row.setting = regime;
  row.check = check;
  row.unit = "conditioned";
  row.max = error;
  row.bound = bound;
  row.verdict = !bound ? Verdict::NotPromised : error <= *bound ? Verdict::Kept : Verdict::Broken;
  return row;
}

std::vector<double> errors_of(const Rows& rows) {
  std::vector<double> errors;
  for (const ResultRow* row : rows) errors.push_back(row ? row->max : -1);
  return errors;
}

TEST(Digest, CountsPromises) {
  RunResult run;
  run.rows = {measured("truth", "a", 1, {})};
  EXPECT_EQ(verdict_line(run), "Nothing was promised in this run");
  run.rows.push_back(measured("truth", "b", 1, 2));
  EXPECT_EQ(verdict_line(run), "The one promise is kept");
  run.rows.push_back(measured("truth", "c", 1, 2));
  EXPECT_EQ(verdict_line(run), "All 2 promises kept");
  run.rows.push_back(measured("truth", "d", 3, 2));
  EXPECT_EQ(verdict_line(run), "1 of 3 promises broken");
}

TEST(Digest, MeasuresStrainByTheBound) {
  EXPECT_EQ(strain(measured("truth", "a", 6, 4)), 1.5);
  EXPECT_EQ(strain(measured("truth", "a", 6, {})), 6);
  EXPECT_EQ(strain(measured("truth", "a", 0, 0)), 0) << "a bound of nothing is kept by nothing";
  EXPECT_EQ(strain(measured("truth", "a", 1e-300, 0)), HUGE_VAL);
}

TEST(Digest, OfBrokenRowsWhatOthersRestOnComesFirst) {
  RunResult run;
  run.rows = {measured("truth", "a", 5, 4),  measured("integral", "a", 3, 2), measured("truth", "b", 9, 8),
              measured("truth", "c", 7, 1),  measured("truth", "d", 1e9, {}), measured("truth", "e", 4, 5),
              measured("truth", "f", 2.5, 2)};
  run.rows[1].is_foundation = true;
  EXPECT_EQ(errors_of(broken_rows(run)), (std::vector<double>{3, 7, 5, 2.5, 9}));
}

// A row without a promise may have any error, and one may be broken by what it lost.
TEST(Digest, TellsWhatIsBrokenThenWhatIsPromised) {
  const ResultRow kept = measured("truth", "a", 1, 2), closer = measured("truth", "a", 2, 2),
                  open = measured("truth", "a", 1e9, {});
  ResultRow lost = measured("truth", "a", 0, 2);
  lost.verdict = Verdict::Broken;
  const ResultRow* falling[] = {&lost, &closer, &kept, &open};
  for (int i = 0; i < 4; ++i)
    for (int k = 0; k < 4; ++k) EXPECT_EQ(more_telling(*falling[i], *falling[k]), i < k) << i << k;
}

TEST(Digest, OfRegimesTheTightestStandsForAProperty) {
  RunResult run;
  run.rows = {measured("scaling", "a", 1, 2), measured("truth", "a", 9, 2), measured("scaling", "b", 3, 2),
              measured("scaling", "c", 2, 2), measured("scaling", "a", 4, 8)};
  run.rows[4].unit = "absolute";
  run.rows.push_back(measured("scaling", "a", 5, 8));
  run.rows.back().order = 1;
  run.rows.push_back(measured("scaling", "a", 6, 8));
  run.rows.back().subject = "triangle.double_layer";
  EXPECT_EQ(errors_of(tightest_properties(run, "triangle.single_layer")), (std::vector<double>{3, 4, 5}));
}

TEST(Digest, TheRecommendedEvaluationInDoubleLeadsATable) {
  RunResult run;
  const std::pair<const char*, const char*> columns[] = {
      {"gauss-8", "double"}, {"closed_form", "float"}, {"closed_form", "double"}};
  for (const auto& [evaluation, scalar] : columns) {
    ResultRow row = measured("truth", "near-edge", 1, {});
    row.evaluation = evaluation;
    row.scalar = scalar;
    // Another formula recommends what is a rule here.
    ResultRow other = row;
    other.subject = "triangle.double_layer";
    row.role = row.evaluation == "closed_form" ? "recommended" : "rule";
    other.role = row.evaluation == "closed_form" ? "rule" : "recommended";
    run.rows.insert(run.rows.begin(), other);
    run.rows.push_back(row);
  }
  run.rows.push_back(measured("scaling", "generic", 1, {}));
  const ErrorTable table = truth_table(run, "triangle.single_layer");
  EXPECT_EQ(table.columns,
            (std::vector<Column>{{"closed_form", "double"}, {"gauss-8", "double"}, {"closed_form", "float"}}));
  EXPECT_EQ(table.regimes, std::vector<std::string>{"near-edge"});
  EXPECT_EQ(truth_table(run, "triangle.double_layer").columns.front(), (Column{"gauss-8", "double"}));
  EXPECT_EQ(role_of(run, "triangle.single_layer", "none"), "");
}

TEST(Digest, ACellOfACageShowsItsMostTellingRow) {
  RunResult run;
  run.rows = {measured("sum", "torus", 1, 2), measured("sum", "cube", 1.5, 2), measured("sum", "torus", 2, 2),
              measured("sum", "torus", 1e9, {}), measured("linear", "torus", 0.5, 2)};
  for (ResultRow& row : run.rows) row.section = RowKey::Section::Cage;
  run.rows.push_back(run.rows[1]);
  run.rows.back().subject = "green";
  run.rows.push_back(measured("sum", "torus", 7, 2));  // of an element
  const CageTable table = cage_table(run);
  EXPECT_EQ(table.columns,
            (std::vector<std::string>{"triangle.single_layer, closed_form, double", "green, closed_form, double"}));
  ASSERT_EQ(table.lines.size(), 3u);
  const std::pair<std::string, std::string> names[] = {{"torus", "sum"}, {"torus", "linear"}, {"cube", "sum"}};
  const std::vector<double> cells[] = {{2, -1}, {0.5, -1}, {1.5, 1.5}};
  for (int i = 0; i < 3; ++i) {
    EXPECT_EQ(std::pair(table.lines[i].cage, table.lines[i].name), names[i]);
    EXPECT_EQ(errors_of(table.lines[i].cells), cells[i]) << i;
  }
}

}  // namespace
}  // namespace cageproof::reports
