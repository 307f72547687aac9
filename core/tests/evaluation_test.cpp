// SPDX-License-Identifier: MIT
#include "cageproof/core/catalogue/evaluation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace cageproof {
namespace {

constexpr std::string_view kFormula = "triangle.single_layer", kOther = "triangle.double_layer";

EvaluationFamily family(std::string_view formula, std::string pattern, Role role, std::vector<std::string> standard) {
  const auto make = [=](std::string_view name) -> std::optional<Evaluation> {
    if (name != pattern && std::ranges::find(standard, name) == standard.end()) return std::nullopt;
    return Evaluation(formula, name, {.description = pattern, .role = role, .max_order = 1});
  };
  return {std::string(formula), pattern, role, standard, make};
}

EvaluationRegister filled() {
  EvaluationRegister evaluations;
  evaluations.add(family(kFormula, "gauss-<N>", Role::Rule, {"gauss-8", "gauss-4"}));
  evaluations.add(family(kOther, "closed_form", Role::Recommended, {"closed_form"}));
  evaluations.add(family(kFormula, "line_form", Role::Recommended, {"line_form"}));
  evaluations.add(family(kFormula, "as-printed", Role::Printed, {}));
  evaluations.add(family(kFormula, "published", Role::Printed, {"published"}));
  evaluations.add(family(kFormula, "certified", Role::Enclosure, {}));
  return evaluations;
}

TEST(evaluation_register, families_are_those_of_the_formula_the_recommended_one_first) {
  const EvaluationRegister evaluations = filled();
  std::vector<std::string> patterns;
  for (const auto* f : evaluations.families(kFormula)) patterns.push_back(f->pattern);
  EXPECT_EQ(patterns, (std::vector<std::string>{"line_form", "as-printed", "certified", "gauss-<N>", "published"}));
  EXPECT_TRUE(evaluations.families("no formula").empty());
}

TEST(evaluation_register, standard_members_begin_with_the_recommended_one) {
  EXPECT_EQ(filled().standard(kFormula), (std::vector<std::string>{"line_form", "gauss-4", "gauss-8", "published"}));
  EXPECT_TRUE(filled().standard("no formula").empty());
}

TEST(evaluation_register, finds_by_formula_and_name) {
  const EvaluationRegister evaluations = filled();
  const auto found = evaluations.find(kFormula, "gauss-8");
  ASSERT_TRUE(found);
  EXPECT_EQ(found->formula().name, kFormula);
  EXPECT_EQ(found->name(), "gauss-8");
  EXPECT_EQ(found->max_order(), 1);
  EXPECT_FALSE(evaluations.find(kOther, "gauss-8"));
  EXPECT_FALSE(evaluations.find(kFormula, "gauss-9"));
}

TEST(evaluation_register, finds_by_another_name) {
  EvaluationRegister evaluations;
  EvaluationFamily renamed = family(kFormula, "line_form", Role::Recommended, {"line_form"});
  renamed.alias = "closed_form";
  evaluations.add(renamed);
  const auto found = evaluations.find(kFormula, "closed_form");
  ASSERT_TRUE(found);
  EXPECT_EQ(found->name(), "line_form");
}

TEST(evaluation_register, finds_by_role_what_verification_runs_before_what_checks_ask_for) {
  const EvaluationRegister evaluations = filled();
  EXPECT_EQ(evaluations.with_role(kFormula, Role::Recommended)->name(), "line_form");
  EXPECT_EQ(evaluations.with_role(kFormula, Role::Rule)->name(), "gauss-8");
  EXPECT_EQ(evaluations.with_role(kFormula, Role::Printed)->name(), "published");
  EXPECT_EQ(evaluations.with_role(kFormula, Role::Enclosure)->name(), "certified");
  EXPECT_FALSE(evaluations.with_role(kFormula, Role::Scheme));
  EXPECT_FALSE(evaluations.with_role("no formula", Role::Rule));
}

TEST(evaluation_register, start_of_program_adds_to_the_instance) {
  const RegisterEvaluation added{family("evaluation_test", "closed_form", Role::Recommended, {})};
  EXPECT_EQ(EvaluationRegister::instance().families("evaluation_test").size(), 1u);
}

TEST(evaluation, runs_the_function_of_the_scalar_asked_for) {
  Evaluation evaluation(kFormula, "constant", {.description = "", .max_order = 0});
  evaluation.set_point<double>([](const Query<double>& query, Result<double>& result) {
    result.reset(1, 3, query.order);
    result.value = {7};
  });
  EXPECT_TRUE(evaluation.supports<double>());
  EXPECT_TRUE(evaluation.supports(ScalarKind::Double));
  EXPECT_FALSE(evaluation.supports<float>());
  EXPECT_FALSE(evaluation.supports(ScalarKind::Digits50));
  Result<double> result;
  evaluation(Query<double>{}, result);
  EXPECT_EQ(result.of(0), std::vector<double>{7});
  Result<float> none;
  EXPECT_THROW(evaluation(Query<float>{}, none), std::bad_function_call);
}

// Value and gradient of the sum of the point's coordinates, times the corner's number.
void numbered(const Query<double>& query, Result<double>& result) {
  result.reset(3, 3, query.order);
  for (int k = 0; k < 3; ++k) {
    result.value[k] = (k + 1) * query.point.sum();
    if (query.order >= 1) std::fill_n(result.gradient.begin() + 3 * k, 3, k + 1);
  }
  result.nodes = 5;
  result.converged = query.point[0] > 0;
}

TEST(evaluation, of_points_answers_batches_stored_or_added_slot_by_slot) {
  Evaluation evaluation(kOther, "numbered", {.description = "", .max_order = 1});
  evaluation.set_point<double>(numbered);
  const std::array<Vec3<double>, 2> points{Vec3<double>(1, 2, 3), Vec3<double>(-1, 0, 0)};
  // Four coordinates, of which the element has numbers 3, 0 and 2.
  std::vector<double> values(8, 100.0), gradients(24, 100.0);
  constexpr std::array<int, 3> slots{3, 0, 2};
  std::array<Statement, 2> statements;
  BatchOutput<double> output{
      .tensors = {values.data(), gradients.data(), nullptr}, .stride = {4, 12, 0}, .slots = slots, .add = true};
  output.statements = statements.data();
  evaluation(Batch<double>{.corners = {}, .points = points, .order = 1}, output);
  EXPECT_EQ(values, (std::vector<double>{112, 100, 118, 106, 98, 100, 97, 99}));
  EXPECT_EQ(gradients[0], 102);
  EXPECT_EQ(gradients[3], 100);
  EXPECT_EQ(gradients[12 + 11], 101);
  EXPECT_EQ(statements[0].nodes, 5u);
  EXPECT_TRUE(statements[0].converged);
  EXPECT_FALSE(statements[1].converged);
  output.add = false;
  evaluation(Batch<double>{.corners = {}, .points = points, .order = 0}, output);
  EXPECT_EQ(values, (std::vector<double>{12, 100, 18, 6, -2, 100, -3, -1}));
}

TEST(evaluation, of_batches_answers_a_point) {
  Evaluation evaluation(kOther, "batched", {.description = "", .max_order = 1});
  evaluation.set_batch<double>([](const Batch<double>& batch, const BatchOutput<double>& output) {
    Result<double> result;
    for (std::size_t p = 0; p < batch.points.size(); ++p) {
      numbered({batch.corners, batch.points[p], batch.order}, result);
      for (int o = 0; o <= batch.order; ++o) output.put(p, o, result.of(o));
      output.state(p, result.statement());
    }
  });
  Result<double> found, expected;
  const Query<double> query{.corners = {}, .point = Vec3<double>(-1, 5, 2), .order = 1};
  evaluation(query, found);
  numbered(query, expected);
  EXPECT_EQ(found.value, expected.value);
  EXPECT_EQ(found.gradient, expected.gradient);
  EXPECT_TRUE(found.hessian.empty());
  EXPECT_FALSE(found.converged);
  EXPECT_EQ(found.nodes, 5u);
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
