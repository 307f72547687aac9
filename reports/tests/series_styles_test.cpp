// SPDX-License-Identifier: MIT
#include "series_styles.h"

#include "curve_picture.h"
#include "page/rows_json.h"
#include "sample_run.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <map>
#include <set>
#include <tuple>

namespace cageproof::reports::series_styles_test {
namespace {

ResultCurve curve_of(const std::string& formula, const std::string& evaluation, const char* scalar, const char* role) {
  ResultCurve curve;
  curve.subject = formula;
  curve.evaluation = evaluation;
  curve.scalar = scalar;
  curve.role = role;
  curve.setting = "near-edge";
  curve.check = "truth";
  curve.parameter_name = "distance / size";
  curve.parameters = {0.1, 0.01};
  curve.errors = {1, 2};
  return curve;
}

// Fifteen evaluations of one formula in three scalars; another formula recommends the eighth of them.
RunResult run_of_many() {
  RunResult run;
  for (int e = 0; e < 15; ++e)
    for (const char* scalar : {"double", "float", "mp50"})
      run.curves.push_back(curve_of("a", fmt::format("rule-{}", e), scalar, e == 0 ? "recommended" : "rule"));
  run.curves.push_back(curve_of("b", "rule-8", "double", "recommended"));
  run.curves.push_back(curve_of("b", "another", "double", "rule"));
  return run;
}

TEST(SeriesStyles, NoTwoSeriesOfAFormulaLookAlike) {
  const RunResult run = run_of_many();
  const SeriesStyles styles(run);
  std::map<std::string, std::set<std::tuple<std::string, std::vector<int>>>> looks;
  std::map<std::string, std::size_t> count;
  for (const ResultCurve& curve : run.curves) {
    const SeriesStyle style = styles.of(curve.evaluation, curve.scalar);
    looks[curve.subject].emplace(style.colour, style.dash);
    ++count[curve.subject];
  }
  for (const auto& [formula, different] : looks) EXPECT_EQ(different.size(), count[formula]) << formula;
}

TEST(SeriesStyles, AreTheSameOnScreenAndInPrint) {
  const RunResult run = run_of_many();
  const SeriesStyles styles(run);
  for (const std::string formula : {"a", "b"}) {
    std::string commands;
    for (const CurvePicture& picture : curve_pictures(run))
      if (picture.subject == formula) commands = picture.picture.commands;
    for (const Json& curve : curves_json(run, formula)) {
      const std::string evaluation = curve["evaluation"], scalar = curve["scalar"];
      const SeriesStyle style = styles.of(evaluation, scalar);
      EXPECT_EQ(curve["style"]["colour"], style.colour);
      // The legend's entry of that series: its colour stands before its title.
      const auto title = commands.find(fmt::format("title '{}, {}'", evaluation, scalar));
      ASSERT_NE(title, commands.npos) << evaluation << commands;
      const std::string entry = commands.substr(commands.rfind("keyentry", title), title);
      EXPECT_NE(entry.find(fmt::format("rgb '{}'", style.colour)), entry.npos) << entry.substr(0, 120);
      std::string dash = curve["style"]["dash"];
      std::ranges::replace(dash, ' ', ',');
      EXPECT_NE(entry.find(dash.empty() ? "dashtype 1 " : fmt::format("dashtype ({})", dash)), entry.npos) << entry;
    }
  }
}

// Times differ from run to run, and looks may not.
TEST(SeriesStyles, AreAFunctionOfWhatWasFound) {
  RunResult run = run_of_many();
  const SeriesStyle before = SeriesStyles(run).of("another", "double");
  run.sessions.push_back({"", 1, "", {}, {{"a", "new", 0, 10}, {"b", "rule-3", 0, 10}}});
  EXPECT_EQ(SeriesStyles(run).of("another", "double").colour, before.colour);
}

}  // namespace
}  // namespace cageproof::reports::series_styles_test
