// SPDX-License-Identifier: MIT
#include "cageproof/reports/compare_changes.h"

#include "../src/compare_rank_test.h"
#include "cageproof/core/input_error.h"
#include "cageproof/reports/compare_formats.h"
#include "cageproof/reports/summary.h"
#include "json_value.h"
#include "sample_run.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

namespace cageproof::reports {
namespace {

Changes judged(const RunResult& before, const RunResult& after, double tolerance = 2) {
  return changes_of_summaries(summary_json(before), summary_json(after), {}, tolerance, "old", "new");
}

// The change of one kind in the first row.
Changes changed(auto before_change, auto after_change, double tolerance = 2) {
  RunResult before = sample_run(1, 1), after;
  before.rows[0].unit = "conditioned";
  before.rows[0].max = 10;
  before.rows[0].samples = 100;
  before.rows[0].verdict = Verdict::Kept;
  before_change(before.rows[0]);
  after = before;
  after_change(after.rows[0]);
  return judged(before, after, tolerance);
}

constexpr auto nothing = [](ResultRow&) {};

TEST(CompareChanges, FailsOnlyBeyondTheTolerance) {
  const auto by = [](double factor) { return changed(nothing, [=](ResultRow& row) { row.max *= factor; }); };
  EXPECT_TRUE(by(1).changes.empty());
  EXPECT_TRUE(by(2.1).fails());
  EXPECT_EQ(by(2.1).count(Change::Kind::Worse), 1U);
  EXPECT_FALSE(by(1.9).fails());
  EXPECT_EQ(by(1.9).count(Change::Kind::Slight), 1U);
  EXPECT_FALSE(by(0.1).fails());
  EXPECT_EQ(by(0.1).count(Change::Kind::Better), 1U);
  EXPECT_TRUE(by(std::nan("")).fails());
}

TEST(CompareChanges, TakesErrorsBelowOneRoundingForOne) {
  const auto from_to = [](double from, double to) {
    return changed([=](ResultRow& row) { row.max = from; }, [=](ResultRow& row) { row.max = to; });
  };
  EXPECT_TRUE(from_to(0.01, 0.9).changes.empty());
  EXPECT_FALSE(from_to(0, 1.9).fails());
  EXPECT_TRUE(from_to(0, 2.1).fails());
}

TEST(CompareChanges, FailsForWorseVerdictsAndLostPromisesWhateverTheTolerance) {
  EXPECT_TRUE(changed(
                  nothing, [](ResultRow& row) { row.verdict = Verdict::Broken; }, 1e9)
                  .fails());
  EXPECT_FALSE(changed([](ResultRow& row) { row.verdict = Verdict::Broken; },
                       [](ResultRow& row) { row.verdict = Verdict::Kept; })
                   .fails());
  EXPECT_TRUE(changed(
                  nothing, [](ResultRow& row) { row.subject = "another"; }, 1e9)
                  .fails());
  EXPECT_TRUE(changed(
                  nothing, [](ResultRow& row) { row.nonfinite = 1; }, 1e9)
                  .fails());
  EXPECT_TRUE(changed(nothing, [](ResultRow& row) { row.bound = 1e6; }).fails());
}

// Both tails of m = n = 5, of which C(10, 5) = 252 arrangements exist.
TEST(CompareChanges, RankTestIsExact) {
  EXPECT_NEAR(rank_test({1, 2, 3, 4, 5}, {6, 7, 8, 9, 10}), 2. / 252, 1e-15);
  EXPECT_NEAR(rank_test({1, 2, 3, 4, 6}, {5, 7, 8, 9, 10}), 4. / 252, 1e-15);
  EXPECT_NEAR(rank_test({1, 4}, {2, 3, 5}), rank_test({2, 3, 5}, {1, 4}), 1e-15);
  EXPECT_NEAR(least_rank_p(5, 5), 2. / 252, 1e-15);
  EXPECT_EQ(rank_test({1, 1, 1}, {1, 1, 1}), 1);
  std::vector<double> low, high;
  for (int i = 0; i < 25; ++i) low.push_back(i), high.push_back(i + 10);
  EXPECT_LT(rank_test(low, high), 1e-3);
  EXPECT_GT(rank_test(low, low), 0.9);
}

std::string benchmark(const std::vector<double>& times) {
  Json output{{"context", {{"date", "2026-01-02"}}}, {"benchmarks", Json::array()}};
  for (const double time : times)
    output["benchmarks"].push_back(
        {{"name", "layer"}, {"run_type", "iteration"}, {"cpu_time", time}, {"real_time", 7}, {"time_unit", "us"}});
  return dump(output);
}

TEST(CompareChanges, CallsTimesSlowerOnlyWhereRanksShowIt) {
  const auto kind = [](const std::vector<double>& before, const std::vector<double>& after) {
    const Changes found = changes_of_benchmarks(benchmark(before), benchmark(after), 1.5, "old", "new");
    return found.changes.empty() ? "none" : std::string(name_of(found.changes[0].kind));
  };
  const std::vector<double> before{10, 11, 12, 13, 14};
  EXPECT_EQ(kind(before, {20, 21, 22, 23, 24}), "worse");
  EXPECT_EQ(kind(before, {15, 16, 17, 18, 19.5}), "within the tolerance");
  EXPECT_EQ(kind(before, {5, 6, 7, 8, 9}), "better");
  EXPECT_EQ(kind(before, {9, 10.5, 30, 31, 32}), "within the tolerance");
  EXPECT_EQ(kind({10}, {20}), "undecided");
  EXPECT_EQ(kind(before, before), "none");
  EXPECT_THROW(changes_of_benchmarks(benchmark({1}), "{}", 2, "old", "new"), InputError);
  EXPECT_THROW(changes_of_benchmarks(benchmark({}), benchmark({}), 2, "old", "new"), InputError);
}

TEST(CompareChanges, NamesTheFileWhereAMemberIsNoText) {
  for (const char* member : {"name", "run_type", "run_name", "time_unit"}) {
    Json output = Json::parse(benchmark({1, 2}));
    output["benchmarks"][1][member] = 3;
    try {
      changes_of_benchmarks(benchmark({1, 2}), dump(output), 2, "old", "new");
      ADD_FAILURE() << member;
    } catch (const InputError& e) {
      EXPECT_EQ(std::string(e.what()), fmt::format("new: {} of a benchmark is no text", member));
    }
  }
}

TEST(CompareChanges, SaysTheSameInEveryFormat) {
  const Changes bad = changed(nothing, [](ResultRow& row) { row.max = 1000; });
  EXPECT_NE(changes_text(bad).find("max 10 -> 1000 (100x)"), std::string::npos);
  EXPECT_TRUE(changes_markdown(bad).starts_with("### Got worse: old -> new"));
  EXPECT_EQ(Json::parse(changes_json(bad))["changes"][0]["ratio"], 100.);
  EXPECT_NE(changes_junit(bad).find("failures=\"1\""), std::string::npos);
  EXPECT_EQ(Json::parse(badge_json(bad))["color"], "red");
  EXPECT_NE(badge_svg(bad).find("1 got worse"), std::string::npos);
  const Changes times = changes_of_benchmarks(benchmark({1, 2, 3}), benchmark({2, 4, 6}), 9, "old", "new");
  EXPECT_EQ(Json::parse(smaller_is_better_json(times))[0],
            Json::parse(R"({"name":"layer","unit":"ns","value":4000.0,"range":"2e+03"})"));
  EXPECT_EQ(Json::parse(bencher_json(times))["layer"]["latency"],
            Json::parse(R"({"value":4000.0,"lower_value":2000.0,"upper_value":6000.0})"));
  EXPECT_EQ(Json::parse(history_line(times, "abc"))["commit"], "abc");
  EXPECT_EQ(Json::parse(history_line(times, ""))["figures"]["layer"], 4000.);
}

}  // namespace
}  // namespace cageproof::reports
