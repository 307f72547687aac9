// SPDX-License-Identifier: MIT
// The table of promises: whole for what people rely on, and for other evaluations enough to tell another formula.
#include "cageproof/validation/promise.h"
#include "cageproof/validation/check.h"
#include "cageproof/validation/regime.h"
#include "cageproof/validation/truth.h"
#include "promises/verdicts.h"

#include <gtest/gtest.h>

namespace cageproof::validation {
namespace {

std::optional<double> bound(const char* subject, const char* evaluation, const char* regime, int order = 0) {
  return promise_for({"truth", subject, evaluation, "double", regime, order}).bound;
}

// An evaluation that is 170 % off, far away and within one size.
double error_when_wrong(const char* subject, const char* evaluation, double distance) {
  const Formula& formula = formula_named(subject);
  Sample sample{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {0.25, 0.25, distance}, {}, 0, 0};
  if (formula.corners() == 4) sample.corners = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0.3}, {0, 1, 0}};
  for (const Parameter& p : formula.parameters) sample.parameters.push_back(p.preset);
  const Truth truth = truth_from(truth_source(formula), sample, 0);
  Result<double> f = evaluate<double>(evaluation_named(subject, evaluation), sample, 0);
  for (double& x : f.value) x *= 2.7;
  return conditioned_error(f, truth, 0, Mp100(0x1p-53));
}

TEST(promises, of_rules_printed_forms_and_schemes_catch_another_formula) {
  struct Case {
    const char *subject, *evaluation, *regime;
  };
  for (const Case& c : {Case{"triangle.double_layer", "published", "generic"},
                        {"triangle.double_layer", "gauss-4", "far"},
                        {"triangle.kelvin_traction", "gauss-16", "far"},
                        {"triangle.kelvin_traction", "three-quad-75", "far"},
                        {"triangle.single_layer", "near-singular-16", "generic"},
                        {"quad.mean_value", "riemann-4", "far"},
                        {"quad.mean_value", "riemann-10", "generic"},
                        {"quad.mean_value", "tessellated-5", "far"}}) {
    const auto promised = bound(c.subject, c.evaluation, c.regime);
    ASSERT_TRUE(promised) << c.evaluation << ' ' << c.regime;
    EXPECT_GT(error_when_wrong(c.subject, c.evaluation, std::string_view(c.regime) == "far" ? 10 : 0.6), *promised)
        << c.subject << ' ' << c.evaluation;
  }
}

TEST(promises, stay_away_from_weak_spots) {
  EXPECT_FALSE(bound("triangle.double_layer", "published", "near-edge"));
  EXPECT_FALSE(bound("triangle.double_layer", "gauss-16", "near-face"));
  EXPECT_FALSE(bound("quad.mean_value", "riemann-10", "near-vertex"));
  EXPECT_EQ(bound("triangle.double_layer", "closed_form", "near-edge"), 64);
}

// A forgotten bound would look like a decision to promise nothing.
TEST(promises, are_made_or_declined_for_every_check_of_what_people_rely_on) {
  int asked = 0;
  for (const Formula& formula : catalogue())
    for (const std::string& name : EvaluationRegister::instance().standard(formula.name)) {
      const Evaluation evaluation = evaluation_named(formula.name, name);
      if (evaluation.role() != Role::Recommended && evaluation.role() != Role::Stated &&
          evaluation.role() != Role::ClosedForm)
        continue;
      for (const auto& check : checks())
        for (const Regime& regime : regimes())
          for (const ScalarKind scalar : scalar_kinds) {
            if (!exists_for(regime, formula.element) || !evaluation.supports(scalar) ||
                !check->applies(formula, evaluation, scalar, regime.name))
              continue;
            ++asked;
            // Which orders a check asks, its findings say; verdicts ask for the row of each.
            bool in_table = false;
            for (int order = 0; order < 3; ++order)
              in_table = in_table ||
                         promise_for({check->name(), formula.name, name, name_of(scalar), regime.name, order}).in_table;
            EXPECT_TRUE(in_table) << check->name() << ' ' << formula.name << ' ' << name << ' ' << name_of(scalar)
                                  << ' ' << regime.name;
          }
    }
  EXPECT_GT(asked, 1000);
}

TEST(promises, are_missed_where_the_table_has_no_row) {
  const auto truth_of = [](std::string_view evaluation) {
    return PromiseKey{"truth", "triangle.single_layer", evaluation, "double", "generic", 0};
  };
  // A rule's name does not make a rule of what people rely on.
  for (const Role role : {Role::Recommended, Role::Stated, Role::Batched})
    for (const std::string_view name : {"novel_form", "gauss-99", "near-singular-99", "adaptive"})
      EXPECT_THROW(require_row(truth_of(name), role), std::logic_error) << name_of(role) << ' ' << name;
  EXPECT_NO_THROW(require_row(truth_of("novel_form"), Role::Foreign));
  EXPECT_NO_THROW(require_row(truth_of("gauss-12"), Role::Rule));
  EXPECT_THROW(require_row({"novel_check", "green", "batched", "double", "cube", 0}, std::nullopt), std::logic_error);
}

// The name decides nothing: what the program's own register says of an evaluation does.
TEST(promises, stop_a_verdict_without_a_row) {
  ResultRow row;
  row.section = RowKey::Section::Cage;
  row.subject = "green";
  row.evaluation = "batched";
  row.scalar = "double";
  row.setting = "cube";
  row.check = "cage_truth";
  EXPECT_NO_THROW(judge(row));
  row.check = "novel_check";
  EXPECT_THROW(judge(row), std::logic_error);
  row.check = "cage_truth";
  row.scalar = "mp50";
  EXPECT_THROW(judge(row), std::logic_error);
}

}  // namespace
}  // namespace cageproof::validation
