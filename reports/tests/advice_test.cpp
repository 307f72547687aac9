// SPDX-License-Identifier: MIT
#include "page/advice.h"

#include "cageproof/core/catalogue/role.h"
#include "sample_run.h"

#include <gtest/gtest.h>

#include <limits>

namespace cageproof::reports {
namespace {

constexpr double kNowhere = std::numeric_limits<double>::infinity();

std::vector<std::string> names_of(const std::vector<Choice>& choices) {
  std::vector<std::string> names;
  names.reserve(choices.size());
  for (const Choice& choice : choices) names.push_back(choice.evaluation);
  return names;
}

TEST(Advice, LeavesOutWhatIsSlowerAndLessAccurate) {
  using Names = std::vector<std::string>;
  EXPECT_EQ(names_of(without_dominated({{"slow", 0.1, 300}, {"lead", 1e-15, 100, true}, {"quick", 1, 20}})),
            (Names{"quick", "lead"}));
  // As far and as quick as what is recommended is no reason to take something else; two equal rules are a choice.
  EXPECT_EQ(names_of(without_dominated({{"equal", 0.1, 100}, {"lead", 0.1, 100, true}})), Names{"lead"});
  EXPECT_EQ(names_of(without_dominated({{"one", 0.1, 100}, {"two", 0.1, 100}})), (Names{"one", "two"}));
  // The recommended one stays, behind a rule that is better in both, and before one that only reaches further.
  EXPECT_EQ(names_of(without_dominated({{"lead", kNowhere, 100, true}, {"far", 0.1, 900}, {"quick", 1, 20}})),
            (Names{"quick", "lead", "far"}));
}

// Each further choice is slower and reaches further, whatever the choices are.
TEST(Advice, IsInTheOrderOfPareto) {
  std::vector<Choice> many;
  many.reserve(60);
  for (int i = 0; i < 60; ++i)
    many.push_back({std::to_string(i), 1.0 + (i + 5) * 37 % 61, 1.0 + (i + 11) * 23 % 59, false});
  const std::vector<Choice> left = without_dominated(many);
  ASSERT_GT(left.size(), 1u);
  for (std::size_t i = 1; i < left.size(); ++i) {
    EXPECT_LT(left[i - 1].nanoseconds, left[i].nanoseconds);
    EXPECT_GT(left[i - 1].reach, left[i].reach);
  }
}

TEST(Advice, NamesNoRuleThatTheRecommendedEvaluationBeats) {
  RunResult run = sample_run(1, 2);
  const std::string formula = run.rows[0].subject;
  run.sessions[0].times = {{formula, "gauss-8", 0, 5000}, {formula, "closed_form", 0, 900}};
  EXPECT_EQ(advice(run, formula).find("gauss-8"), std::string::npos) << advice(run, formula);
  run.sessions[0].times[0].nanoseconds = 50;
  const std::string text = advice(run, formula);
  ASSERT_NE(text.find("gauss-8, 50 ns"), std::string::npos) << text;
  EXPECT_LT(text.find("gauss-8"), text.find("closed_form")) << text;
}

}  // namespace
}  // namespace cageproof::reports
