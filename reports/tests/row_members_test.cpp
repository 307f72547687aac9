// SPDX-License-Identifier: MIT
// One row, every member of it with a value of its own, in each form that the table of members gives it.
#include "row_members.h"

#include "cageproof/reports/journal.h"
#include "cageproof/reports/summary.h"
#include "partial_result_json.h"
#include "page/rows_json.h"
#include "tables.h"

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

namespace cageproof::reports {
namespace {

constexpr std::array<std::uint64_t, 3> errors_below{2, 0, 1};

void set_shared(RowFigures& figures) {
  figures.unit = "conditioned";
  figures.role = "recommended";
  figures.asked = 2021;
  figures.without_truth = 7;
  figures.unreached = 5;
  figures.declined = 3;
  figures.max_relative = 1.25e-14;
  figures.total_loss = 4.5e15;
}

RunResult one_row() {
  ResultRow row;
  static_cast<RowKey&>(row) = {
      RowKey::Section::Element, "triangle.double_layer", "closed_form", "double", "near-edge", "truth", "here", 1};
  set_shared(row);
  row.samples = 2000;
  row.nonfinite = 1;
  row.max = HUGE_VAL;
  row.p999 = 50.5;
  row.median = 0.1;
  row.bound = 64;
  row.verdict = Verdict::Broken;
  row.reason = "backward stable, \"everywhere\"";
  row.histogram.assign(ErrorHistogram::bin_count + 2, 0);
  std::ranges::copy(errors_below, row.histogram.begin() + 49);
  WorstCase worst{HUGE_VAL, 1e-8, 12, {{0.1, 0, 0}, {1, -0.0, 0}, {0, 1, 0}}, {0.5, 0.25, 1e-300}, {}};
  worst.relative = 0.5;
  worst.furthest = {4, 0.125, "2.5e-01"};
  row.worst = {worst};
  RunResult result;
  result.rows = {row};
  return result;
}

std::string journal_line() {
  Tally tally;
  set_shared(tally);
  tally.errors.add(0.1);
  return dump(row_json(one_row().rows[0], tally));
}

// The texts that files had when the test was written. After a change on purpose, copy what is printed.
void expect_golden(const std::string& name, const std::string& text) {
  std::ifstream file(std::string(CAGEPROOF_GOLDEN) + "/" + name);
  std::stringstream golden;
  golden << file.rdbuf();
  EXPECT_EQ(text + "\n", golden.str()) << name;
}

TEST(RowMembers, SummaryIsAsItWas) {
  expect_golden("row.summary.json", dump(Json::parse(summary_json(one_row()))["rows"][0]));
}

TEST(RowMembers, TableIsAsItWas) {
  std::string csv = results_csv(one_row());
  csv.pop_back();
  expect_golden("row.csv", csv);
}

TEST(RowMembers, PageIsAsItWas) {
  const RunResult run = one_row();
  expect_golden("row.page.json", dump(rows_json({&run.rows[0]}, WorstPlaces(run))));
}

TEST(RowMembers, JournalIsAsItWas) { expect_golden("row.journal.json", journal_line()); }

TEST(RowMembers, TallyComesBackFromTheJournal) {
  const Json json = Json::parse(journal_line());
  EXPECT_EQ(key_of(json["key"]), static_cast<const RowKey&>(one_row().rows[0]));
  const RowFigures figures = figures_of(json);
  Json again{{"key", json["key"]}};
  add_figures(again, figures);
  for (const auto& [name, value] : again.items()) EXPECT_EQ(value, json[name]) << name;
  EXPECT_EQ(again.size(), 9u) << "the key, and eight members that a tally shares with its row";
}

TEST(RowMembers, RefuseWhatIsNoFigure) {
  EXPECT_THROW(figures_of(Json{{"asked", -1}}), std::invalid_argument);
  EXPECT_THROW(figures_of(Json{{"total_loss", "much"}}), std::invalid_argument);
  EXPECT_THROW(key_of(Json::array({"cell", "", "", "", "", "", "", 0})), std::invalid_argument);
  EXPECT_THROW(key_of(Json::array({"cage", "", "", "", "", "", "", 3})), std::invalid_argument);
  EXPECT_THROW(key_of(Json::array({"cage"})), Json::exception);
}

}  // namespace
}  // namespace cageproof::reports
