// SPDX-License-Identifier: MIT
// What the table of promises says of evaluations that nobody relies on: enough to tell another formula.
#include "cageproof/validation/promise.h"
#include "cageproof/validation/truth.h"

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

}  // namespace
}  // namespace cageproof::validation
