// SPDX-License-Identifier: MIT
#include "page/given_cage.h"
#include "page/pages.h"
#include "sample_run.h"

#include <gtest/gtest.h>

#include <cmath>

namespace cageproof::reports::given_cage_test {
namespace {

ResultRow made_row(const char* kind, const char* check, const char* place, double relative, Verdict verdict) {
  ResultRow row;
  row.section = RowKey::Section::Cage;
  row.subject = kind;
  row.evaluation = "batched";
  row.role = "batched";
  row.scalar = "double";
  row.setting = "folder/my_cage.obj";
  row.check = check;
  row.place = place;
  row.samples = 10;
  row.max = row.max_relative = relative;
  if (verdict != Verdict::NotPromised) row.bound = verdict == Verdict::Kept ? relative * 2 : relative / 2;
  row.verdict = verdict;
  return row;
}

// Two kinds that keep everything, of which green is quicker; one quicker still that reproduces nothing.
RunResult run_of_cage() {
  RunResult run;
  run.settings = {{"scope", "the cage only"}, {"cage", "folder/my_cage.obj"}, {"points", "my_mesh.obj"}};
  for (const char* kind : {"mean_value", "green"}) {
    run.rows.push_back(made_row(kind, "cage_block_error", "inside", 1e-15, Verdict::Kept));
    run.rows.push_back(made_row(kind, "cage_block_error", "far", 1e-11, Verdict::Kept));
    run.rows.push_back(made_row(kind, "partition_of_unity", "inside", 1e-16, Verdict::Kept));
    run.rows.push_back(made_row(kind, "linear_reproduction", "inside", 1e-16, Verdict::Kept));
    run.rows.push_back(made_row(kind, "linear_reproduction", "mesh", 3e-16, Verdict::Kept));
  }
  run.rows.push_back(made_row("somigliana", "cage_block_error", "inside", 1e-3, Verdict::NotPromised));
  run.sessions.push_back(
      {"",
       1,
       "",
       {},
       {{"mean_value", "batched", 0, 2500}, {"green", "batched", 0, 850}, {"somigliana", "batched", 0, 9}}});
  run.fields.push_back({.title = "folder/my_cage.obj, green coordinates: linear reproduction",
                        .unit = "cage sizes",
                        .data = "fields/green.vti",
                        .picture = "pictures/green.png",
                        .largest = 1e-3});
  return run;
}

std::string index_of(const RunResult& run) { return pages(run, {}, {}).at("index.html"); }

// The section's text up to the next section.
std::string given_cage_section(const std::string& page) {
  const auto at = page.find("id=\"given-cage\"");
  return at == page.npos ? "" : page.substr(at, page.find("</section>", at) - at);
}

TEST(GivenCage, NamesTheQuickestKindThatKeepsAllAndReproducesLinearFunctions) {
  const std::string page = index_of(run_of_cage()), section = given_cage_section(page);
  EXPECT_NE(page.find("All 10 promises kept for my_cage.obj</h1>"), page.npos);
  EXPECT_NE(section.find("The quickest that keeps its promises: green. It keeps all 5 of them, reproduces linear "
                         "functions, and takes 850 ns per point. It was compared with its truth at "),
            section.npos)
      << section;
  // It comes first, and what the choice leaves out is said.
  EXPECT_LT(section.find("<tr class=\"taken\"><th scope=\"row\"><a href=\"cages/folder-my_cage.obj.html\">green</a>"),
            section.find(">mean_<wbr>value</a>"))
      << section;
  EXPECT_NE(section.find("It does not look at how a kind deforms"), section.npos);
  EXPECT_NE(section.find("The rule: of the kinds that keep all promises"), section.npos);
  // The picture stands above the table.
  EXPECT_LT(section.find("src=\"pictures/green.png\""), section.find("<table class=\"kinds\""));
  EXPECT_NE(section.find("<table class=\"kinds\""), section.npos);
  EXPECT_NE(section.find("my_mesh.obj"), section.npos);
  EXPECT_LT(page.find("id=\"given-cage\""), page.find("id=\"how\""));
}

TEST(GivenCage, NamesTheMostAccurateOfKindsWhoseTimesAreAlike) {
  RunResult run = run_of_cage();
  run.sessions[0].times[0].nanoseconds = 1000;
  for (ResultRow& row : run.rows)
    if (row.subject == "mean_value" && row.place == "inside") row.max = row.max_relative = 1e-16;
  EXPECT_NE(given_cage_section(index_of(run)).find("promises: mean_value."), std::string::npos);
  run.sessions[0].times[0].nanoseconds = 1100;
  EXPECT_NE(given_cage_section(index_of(run)).find("promises: green."), std::string::npos);
}

TEST(GivenCage, HasARowOfEachKind) {
  const RunResult run = run_of_cage();  // its rows are pointed to
  const auto kinds = kinds_in_cage(run);
  ASSERT_EQ(kinds.size(), 3U);
  EXPECT_EQ(kinds[1].kind, "green");
  EXPECT_EQ(kinds[1].error_inside, 1e-15);
  EXPECT_EQ(kinds[1].error_elsewhere, 1e-11);
  EXPECT_EQ(kinds[1].worst_elsewhere, "far");
  ASSERT_NE(kinds[1].at_points, nullptr);
  EXPECT_EQ(kinds[1].at_points->max_relative, 3e-16);
  EXPECT_EQ(kinds[1].kept, 5U);
  EXPECT_FALSE(kinds[2].reproduces_linear);
  const std::string section = given_cage_section(index_of(run));
  EXPECT_NE(
      section.find("<td class=\"n\">11 (far)</td><td class=\"n\">3e-16</td><td class=\"n\">850 ns</td><td>yes</td>"),
      section.npos)
      << section;
}

TEST(GivenCage, SaysWhetherCoordinatesAreNegativeAtThePoints) {
  EXPECT_EQ(given_cage_section(index_of(run_of_cage())).find("Not negative"), std::string::npos) << "none was asked";
  RunResult run = run_of_cage();
  const auto add = [&](const char* kind, const char* place, double roundings, double below) {
    run.rows.push_back(made_row(kind, "non_negativity", place, below, Verdict::NotPromised));
    run.rows.back().max = roundings;
  };
  add("mean_value", "inside", 3e14, .5);
  add("mean_value", "mesh", 12, 1e-15);
  add("green", "mesh", 1e14, .125);
  add("green", "inside", 0, 0);
  const std::string section = given_cage_section(index_of(run));
  EXPECT_NE(section.find("<td>yes</td><td>yes</td><td>yes</td>"), section.npos) << "a rounding at the points";
  EXPECT_NE(section.find("<td>yes</td><td>yes</td><td>no, down to −0.13"), section.npos) << section;
  EXPECT_NE(section.find("<td>not measured</td><td>not measured</td><td>–</td>"), section.npos) << section;
}

TEST(GivenCage, IsNotTakenWhereItBreaksAPromise) {
  RunResult run = run_of_cage();
  run.rows.push_back(made_row("green", "cage_truth", "outside", 1e-3, Verdict::Broken));
  const std::string page = index_of(run), section = given_cage_section(page);
  EXPECT_NE(page.find("1 of 11 promises broken for my_cage.obj</h1>"), page.npos);
  EXPECT_NE(section.find("promises: mean_value."), section.npos) << section;
  EXPECT_LT(page.find("id=\"given-cage\""), page.find("id=\"broken\""));
}

// A verdict on points outside says nothing of those that are deformed.
TEST(GivenCage, IsNotTakenWhereNothingWasComparedAtTheCage) {
  RunResult run = run_of_cage();
  const auto leave = [&](const char* place) {
    for (ResultRow& row : run.rows)
      if (row.subject == "green" && row.check == "cage_block_error" && row.place == "inside") row.place = place;
  };
  leave("outside");
  std::string section = given_cage_section(index_of(run));
  EXPECT_NE(section.find("promises: mean_value."), section.npos) << section;
  EXPECT_NE(section.find("<td class=\"n\">not compared</td><td class=\"n\">0</td><td class=\"n\">11 (far)</td>"),
            section.npos)
      << section;
  leave("near-face");
  for (ResultRow& row : run.rows)
    if (row.check == "cage_block_error" && row.place == "inside") row.samples = 0;
  section = given_cage_section(index_of(run));
  EXPECT_NE(section.find("compared with its truth in, on or next to the cage in this suite, so none is named"),
            section.npos)
      << section;
}

TEST(GivenCage, ShowsNoPictureOfRoundingNoise) {
  RunResult run = run_of_cage();
  run.fields.front().largest = 1e-16;
  EXPECT_EQ(given_cage_section(index_of(run)).find("<img"), std::string::npos);
  run.fields.push_back({.title = "folder/my_cage.obj, mean_value coordinates: errors of gauss-8, hybrid",
                        .data = "fields/scene.vti",
                        .picture = "pictures/scene.png",
                        .largest = 0.1});
  const std::string section = given_cage_section(index_of(run));
  EXPECT_NE(section.find("src=\"pictures/scene.png\" alt=\"my_cage.obj, mean_value coordinates"), section.npos)
      << section;
}

TEST(GivenCage, SaysHowManyPointsWereAsked) {
  RunResult run = run_of_cage();
  run.settings["samples"] = "15";
  for (ResultRow& row : run.rows) row.asked = row.place == "mesh" ? 434 : 12;
  run.rows.push_back(made_row("green", "linear_reproduction", "on-face", 0, Verdict::Kept));
  run.rows.back().asked = 1048;
  const std::string page = index_of(run);
  EXPECT_NE(page.find("coordinates in the cage my_cage.obj. Suite , up to 24 points off the cage, 1,048 on it, 434 of "
                      "those that were given, seed 0."),
            page.npos)
      << page.substr(page.find("What was run"), 300);
  EXPECT_EQ(page.find("samples per formula"), page.npos);
}

TEST(GivenCage, NotFiniteIsNoDigit) {
  RunResult run = run_of_cage();
  run.rows.front().nonfinite = 1;
  EXPECT_EQ(kinds_in_cage(run).front().error_inside, HUGE_VAL);
}

TEST(GivenCage, NamesNoQuickestWithoutTimes) {
  RunResult run = run_of_cage();
  run.sessions.clear();
  const std::string section = given_cage_section(index_of(run));
  EXPECT_NE(section.find("No kind was timed in this run"), section.npos) << section;
  EXPECT_EQ(section.find("Time per point"), section.npos);
}

TEST(GivenCage, SaysWhatIsUndecided) {
  RunResult run = run_of_cage();
  run.rows.push_back(made_row("mean_value", "second_route", "inside", 0, Verdict::Undecided));
  run.rows.back().reason = "too few samples";
  const std::string section = given_cage_section(index_of(run));
  EXPECT_NE(section.find("second_route of mean_value by batched"), section.npos);
  EXPECT_NE(section.find("too few samples"), section.npos);
}

TEST(GivenCage, IsNoSectionOfOtherRuns) { EXPECT_EQ(given_cage_section(index_of(sample_run(1, 1))), ""); }

}  // namespace
}  // namespace cageproof::reports::given_cage_test
