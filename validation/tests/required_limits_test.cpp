// SPDX-License-Identifier: MIT
// Where a limit must exist, against where the reference integral finds one: it takes limits by itself.
#include "truth/required_limits.h"

#include "cageproof/core/catalogue/evaluation.h"

#include <gtest/gtest.h>

#include <cmath>

namespace cageproof::validation {
namespace {

using Limits = std::array<bool, 3>;

Sample sample_at(const Formula& formula, const Vec3<double>& point) {
  Sample sample;
  sample.corners = {{0, 0, 0}, {1, 0, 0}};
  if (formula.corners() == 3) sample.corners.push_back({0, 1, 0});
  if (formula.corners() == 4) sample.corners.insert(sample.corners.end(), {{1, 1, 0}, {0, 1, 0}});
  sample.point = point;
  for (const Parameter& p : formula.parameters) sample.parameters.push_back(p.preset);
  return sample;
}

Limits limits(const char* formula, const Vec3<double>& point) {
  return limits_that_must_exist(formula_named(formula), sample_at(formula_named(formula), point));
}

TEST(limits, all_exist_off_the_element) {
  for (const char* formula : {"triangle.mean_value", "triangle.kelvin_traction", "quad.mean_value"})
    for (const Vec3<double>& point : {Vec3<double>(.25, .25, 1), {.25, -.5, 0}, {.25, .25, 5e-324}, {2, 0, 0}})
      EXPECT_EQ(limits(formula, point), (Limits{true, true, true})) << formula << ' ' << point.transpose();
  EXPECT_EQ(limits("segment.single_layer", {-.5, 0, 0}), (Limits{true, true, true}));
}

TEST(limits, within_an_element_are_those_of_what_does_not_diverge) {
  EXPECT_EQ(limits("triangle.double_layer", {.25, .25, 0}), (Limits{true, true, true}));
  EXPECT_EQ(limits("segment.double_layer", {.25, 0, 0}), (Limits{true, true, true}));
  EXPECT_EQ(limits("triangle.mean_value", {.25, .25, 0}), (Limits{false, false, false}));
  EXPECT_EQ(limits("quad.mean_value", {.25, .25, 0}), (Limits{false, false, false}));
}

TEST(limits, on_the_border_are_those_below_the_degree) {
  for (const Vec3<double>& point : {Vec3<double>(.25, 0, 0), {.5, .5, 0}, {1, 0, 0}}) {
    EXPECT_EQ(limits("triangle.biharmonic_single_layer", point), (Limits{true, true, true}));
    EXPECT_EQ(limits("triangle.biharmonic_double_layer", point), (Limits{true, true, false}));
    EXPECT_EQ(limits("triangle.kelvin_displacement", point), (Limits{true, false, false}));
    EXPECT_EQ(limits("triangle.kelvin_traction", point), (Limits{false, false, false}));
    EXPECT_EQ(limits("triangle.mean_value", point), (Limits{false, false, false}));
  }
}

TEST(limits, are_asked_only_of_inputs) {
  Sample sample = sample_at(formula_named("triangle.single_layer"), {.25, .25, 1});
  sample.point[2] = INFINITY;
  EXPECT_EQ(limits_that_must_exist(formula_named("triangle.single_layer"), sample), Limits{});
  sample.point[2] = 1;
  sample.corners[2] = {2, 0, 0};
  EXPECT_EQ(limits_that_must_exist(formula_named("triangle.single_layer"), sample), Limits{});
}

// As a needle's corners may be once they are rounded to float.
TEST(limits, are_not_asked_of_quads_whose_corners_coincide) {
  const Formula& formula = formula_named("quad.kelvin_traction");
  Sample sample = sample_at(formula, {.25, .25, 1});
  EXPECT_EQ(limits_that_must_exist(formula, sample), (Limits{true, true, true}));
  sample.corners[2] = sample.corners[1];
  sample.point = sample.corners[1];
  EXPECT_EQ(limits_that_must_exist(formula, sample), Limits{});
}

// A needle that was rounded to float, seen from its second corner. Steps in doubles lead away from there.
TEST(limits, at_a_corner_that_is_nearly_straight_are_those_of_the_border) {
  Sample sample;
  sample.corners = {{0x1.96686ep-1, -0x1.41d0bap-2, 0x1.32713p-1},
                    {0x1.96687p-1, -0x1.41d0bcp-2, 0x1.32713p-1},
                    {0x1.966872p-1, -0x1.41d0bep-2, 0x1.32712cp-1},
                    {0x1.1b574cp-3, -0x1.2e0d96p-2, -0x1.84b2ep-3}};
  sample.point = sample.corners[1];
  EXPECT_EQ(limits_that_must_exist(formula_named("quad.solid_angle"), sample), Limits{});
}

TEST(limits, that_must_exist_are_found_by_the_integral) {
  for (const Formula& formula : catalogue()) {
    const auto integral = EvaluationRegister::instance().with_role(formula.name, Role::Integral);
    if (!integral || formula.element == ElementKind::Quad) continue;
    for (const Vec3<double>& point : {Vec3<double>(.25, 0, 0), {0, 0, 0}}) {
      const Sample sample = sample_at(formula, point);
      const Limits required = limits_that_must_exist(formula, sample);
      const Result<Mp50> found = evaluate<Mp50>(*integral, sample, 2);
      for (int o = 0; o < 3; ++o)
        for (const Mp50& x : found.of(o))
          EXPECT_TRUE(!required[o] || isfinite(x)) << formula.name << ", order " << o << ", " << point.transpose();
    }
  }
}

}  // namespace
}  // namespace cageproof::validation
