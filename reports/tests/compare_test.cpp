// SPDX-License-Identifier: MIT
#include "cageproof/reports/compare.h"

#include "cageproof/core/input_error.h"
#include "cageproof/reports/checked_file.h"
#include "cageproof/reports/summary.h"
#include "json_value.h"
#include "sample_run.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace cageproof::reports {
namespace {

Differences compared(const RunResult& before, const RunResult& after, const Renamed& renamed = {}) {
  return compare_summaries(summary_json(before), summary_json(after), renamed);
}

TEST(Compare, FindsReportsEqualThatDifferInOrderReasonsAndEnvironment) {
  const RunResult before = sample_run(2, 2);
  RunResult after = before;
  std::ranges::reverse(after.rows);
  std::ranges::reverse(after.curves);
  after.rows[0].reason = "another";
  after.rows[0].worst.clear();
  after.sessions.clear();
  const Differences found = compared(before, after);
  EXPECT_TRUE(found.same());
  EXPECT_EQ(found.equal, before.rows.size() + before.curves.size() + before.errata.size());
}

// Every figure of a row, one at a time.
TEST(Compare, NamesEveryFigureThatDiffers) {
  const RunResult before = sample_run(1, 1);
  const auto difference = [&](auto change) {
    RunResult after = before;
    change(after.rows[0]);
    const Differences found = compared(before, after);
    EXPECT_EQ(found.gone.size() + found.added.size(), 0u);
    EXPECT_EQ(found.differing.size(), 1u);
    return found.differing.empty() ? "" : found.differing[0];
  };
  const auto expect = [](const std::string& line, const std::string& text) {
    EXPECT_NE(line.find(text), std::string::npos) << line << " has no " << text;
  };
  expect(difference([](ResultRow& row) { row.samples = 7; }), "samples ");
  expect(difference([](ResultRow& row) { row.nonfinite = 7; }), "nonfinite ");
  expect(difference([](ResultRow& row) { row.without_truth = 7; }), "without_truth 0 -> 7");
  expect(difference([](ResultRow& row) { row.declined = 7; }), "declined 0 -> 7");
  // Samples that are lost.
  expect(difference([](ResultRow& row) { row.asked = 7; }), "asked 0 -> 7");
  expect(difference([](ResultRow& row) { row.unreached = 7; }), "unreached 0 -> 7");
  expect(difference([](ResultRow& row) { row.total_loss = 7; }), "total_loss null -> 7.0");
  expect(difference([](ResultRow& row) { row.max = HUGE_VAL; }), "-> inf");
  expect(difference([](ResultRow& row) { row.p999 = std::nextafter(row.p999, 0); }), "p999 ");
  expect(difference([](ResultRow& row) { row.median = 7; }), "median ");
  expect(difference([](ResultRow& row) { row.max_relative = 7; }), "max_relative ");
  expect(difference([](ResultRow& row) { row.bound.reset(); }), "bound 64.0 -> null");
  expect(difference([](ResultRow& row) { row.verdict = Verdict::NotPromised; }), "verdict kept -> not promised");
  expect(difference([](ResultRow& row) { row.unit = "u"; }), "unit conditioned -> u");
  expect(difference([](ResultRow& row) { row.histogram[5] = 1; }), "histogram ");
  RunResult after = before;
  after.curves[0].errors[0] += 1;
  after.errata[0].printed_error += 1;
  EXPECT_EQ(compared(before, after).differing.size(), 2u);
}

TEST(Compare, NamesRowsThatOneReportLacks) {
  const RunResult before = sample_run(1, 1);
  RunResult after = before;
  after.rows[0].check = "another";
  const Differences found = compared(before, after);
  ASSERT_EQ(found.gone.size(), 1u);
  ASSERT_EQ(found.added.size(), 1u);
  EXPECT_NE(found.gone[0].find(" truth "), std::string::npos);
  EXPECT_NE(found.added[0].find(" another "), std::string::npos);
  EXPECT_FALSE(found.same());
}

TEST(Compare, FollowsNewNames) {
  const RunResult before = sample_run(2, 1);
  RunResult after = before;
  for (auto* list : {&after.rows})
    for (ResultRow& row : *list) {
      if (row.evaluation == "quads-75") row.evaluation = "rule-75";
      if (row.subject == before.rows[0].subject && row.evaluation == "closed_form") row.evaluation = "line_form";
    }
  for (ResultCurve& curve : after.curves) {
    if (curve.evaluation == "quads-75") curve.evaluation = "rule-75";
    if (curve.subject == before.rows[0].subject && curve.evaluation == "closed_form") curve.evaluation = "line_form";
  }
  EXPECT_FALSE(compared(before, after).same());
  EXPECT_TRUE(compared(before, after, {{"quads-75", "rule-75"}, {before.rows[0].subject + "/closed_form", "line_form"}})
                  .same());
}

TEST(Compare, ReadsTheFirstSchema) {
  const RunResult run = sample_run(1, 1);
  Json old = Json::parse(summary_json(run));
  old["schema_version"] = 1;
  old["run"] = old["environment"]["sessions"][0];
  old.erase("environment");
  EXPECT_TRUE(compare_summaries(dump(old), summary_json(run), {}).same());
}

// A program of before says nothing of what it did not know; one of today that leaves it out has lost it.
TEST(Compare, LeavesOutWhatAnEarlierSchemaLacks) {
  RunResult run = sample_run(1, 1);
  for (ResultRow& row : run.rows) row.asked = 9;
  Json old = Json::parse(summary_json(run));
  for (Json& row : old["rows"]) row.erase("asked");
  EXPECT_FALSE(compare_summaries(dump(old), summary_json(run), {}).same());
  old["schema_version"] = 2;
  EXPECT_TRUE(compare_summaries(dump(old), summary_json(run), {}).same());
  EXPECT_TRUE(compare_summaries(summary_json(run), dump(old), {}).same());
}

// An entry called closed_form before schema 4 is hybrid today, where such an entry exists.
TEST(Compare, TakesClosedFormsOfEarlierSchemasForHybrids) {
  const RunResult run = sample_run(1, 1);
  Json old = Json::parse(summary_json(run)), today = old;
  std::size_t renamed = 0;
  for (const char* list : {"rows", "curves", "errata"})
    for (Json& entry : today[list])
      if (entry.value("evaluation", "") == "closed_form") {
        entry["evaluation"] = "hybrid";
        ++renamed;
      }
  ASSERT_GT(renamed, 0U);
  EXPECT_FALSE(compare_summaries(dump(old), dump(today), {}).same());
  old["schema_version"] = 3;
  const Differences found = compare_summaries(dump(old), dump(today), {});
  EXPECT_TRUE(found.same());
  EXPECT_EQ(found.taken_for_hybrid, renamed);
  EXPECT_EQ(compare_summaries(dump(old), summary_json(run), {}).taken_for_hybrid, 0U);
}

TEST(Compare, RefusesWhatIsNoSummary) {
  const std::string good = summary_json(sample_run(1, 1));
  for (const std::string& bad : {std::string("{"), std::string("{}"), std::string("{\"schema\":\"cageproof-summary\"}"),
                                 summary_json({}, "cageproof-field")})
    EXPECT_THROW(compare_summaries(good, bad, {}), InputError);
  const auto refused = [&](auto change) -> std::string {
    Json bad = Json::parse(good);
    change(bad);
    try {
      compare_summaries(good, dump(bad), {}, "before", "after");
    } catch (const InputError& error) {
      return error.what();
    }
    return "nothing";
  };
  for (const Json& version : {Json(summary_schema_version + 1), Json(0), Json(-1), Json(99)})
    EXPECT_TRUE(refused([&](Json& json) {
                  json["schema_version"] = version;
                }).starts_with("after: schema_version " + dump(version) + " is unknown"));
  for (const Json& version : {Json("3"), Json(2.5), Json()})
    EXPECT_TRUE(refused([&](Json& json) { json["schema_version"] = version; }).ends_with("is not a whole number"));
  for (const char* list : {"rows", "curves", "fields", "errata"})
    for (const Json& value : {Json(), Json(3), Json::object(), Json::array({nullptr})})
      EXPECT_EQ(refused([&](Json& json) { json[list] = value; }),
                std::string("after: \"") + list + "\" is not a list of objects");
  EXPECT_TRUE(refused([](Json& json) {
                json["histogram_bins"]["bins_per_decade"] = 7;
              }).starts_with("the histograms of before and after have other bins, and cannot be compared: {"));
  EXPECT_NE(refused([](Json& json) { json.erase("histogram_bins"); }).find("none"), std::string::npos);
  const ScratchFolder scratch;
  write_file(scratch.path() / "names", "{\"a\": 1}");
  EXPECT_THROW(read_renamed(scratch.path() / "names"), InputError);
  write_file(scratch.path() / "names", "{\"a\": \"b\"}");
  EXPECT_EQ(read_renamed(scratch.path() / "names"), (Renamed{{"a", "b"}}));
}

}  // namespace
}  // namespace cageproof::reports
