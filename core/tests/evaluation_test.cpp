// SPDX-License-Identifier: MIT
#include "cageproof/core/evaluation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace cageproof {
namespace {

EvaluationFamily family(std::string formula, std::string pattern, std::vector<std::string> standard) {
  return {formula, pattern, standard, [=](std::string_view name) -> std::optional<Evaluation> {
            if (std::ranges::find(standard, name) == standard.end()) return std::nullopt;
            return Evaluation(formula, std::string(name), pattern, 1);
          }};
}

EvaluationRegister filled() {
  EvaluationRegister evaluations;
  evaluations.add(family("f", "gauss-<N>", {"gauss-8", "gauss-4"}));
  evaluations.add(family("g", "closed_form", {"closed_form"}));
  evaluations.add(family("f", "closed_form", {"closed_form"}));
  evaluations.add(family("f", "adaptive", {"adaptive"}));
  return evaluations;
}

TEST(evaluation_register, families_are_those_of_the_formula_by_pattern) {
  const EvaluationRegister evaluations = filled();
  std::vector<std::string> patterns;
  for (const auto* f : evaluations.families("f")) patterns.push_back(f->pattern);
  EXPECT_EQ(patterns, (std::vector<std::string>{"adaptive", "closed_form", "gauss-<N>"}));
  EXPECT_TRUE(evaluations.families("h").empty());
}

TEST(evaluation_register, standard_members_begin_with_the_closed_form) {
  EXPECT_EQ(filled().standard("f"), (std::vector<std::string>{"closed_form", "adaptive", "gauss-4", "gauss-8"}));
  EXPECT_TRUE(filled().standard("h").empty());
}

TEST(evaluation_register, finds_by_formula_and_name) {
  const EvaluationRegister evaluations = filled();
  const auto found = evaluations.find("f", "gauss-8");
  ASSERT_TRUE(found);
  EXPECT_EQ(found->formula(), "f");
  EXPECT_EQ(found->name(), "gauss-8");
  EXPECT_EQ(found->max_order(), 1);
  EXPECT_FALSE(evaluations.find("g", "gauss-8"));
  EXPECT_FALSE(evaluations.find("f", "gauss-9"));
}

TEST(evaluation_register, start_of_program_adds_to_the_instance) {
  const RegisterEvaluation added{family("evaluation_test", "closed_form", {"closed_form"})};
  EXPECT_TRUE(EvaluationRegister::instance().find("evaluation_test", "closed_form"));
}

TEST(evaluation, runs_the_function_of_the_scalar_asked_for) {
  Evaluation evaluation("f", "constant", "", 0);
  evaluation.set<double>([](const Query<double>& query, Result<double>& result) {
    result.reset(2, 3, query.order);
    result.value = {1, 2};
  });
  EXPECT_TRUE(evaluation.supports<double>());
  EXPECT_TRUE(evaluation.supports(ScalarKind::Double));
  EXPECT_FALSE(evaluation.supports<float>());
  EXPECT_FALSE(evaluation.supports(ScalarKind::Digits50));
  Result<double> result;
  evaluation(Query<double>{}, result);
  EXPECT_EQ(result.of(0), (std::vector<double>{1, 2}));
  Result<float> none;
  EXPECT_THROW(evaluation(Query<float>{}, none), std::bad_function_call);
}

TEST(evaluation, reset_forgets_everything_from_before) {
  Result<double> result;
  result.reset(2, 3, 2);
  EXPECT_EQ(result.of(1).size(), 6u);
  EXPECT_EQ(result.of(2).size(), 18u);
  result.hessian[17] = result.value[1] = 5;
  result.stated_digits = 3;
  result.converged = false;
  result.nodes = 9;
  for (int order = 0; order <= 2; ++order) result.radius_of(order) = {1, 2};
  result.reset(1, 2, 0);
  EXPECT_EQ(result.value, std::vector<double>{0});
  EXPECT_TRUE(result.gradient.empty());
  EXPECT_TRUE(result.hessian.empty());
  EXPECT_TRUE(std::isnan(result.stated_digits));
  EXPECT_TRUE(result.converged);
  EXPECT_EQ(result.nodes, 0u);
  EXPECT_TRUE(result.value_radius.empty() && result.gradient_radius.empty() && result.hessian_radius.empty());
}

}  // namespace
}  // namespace cageproof
