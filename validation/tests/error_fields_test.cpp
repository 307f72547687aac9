// SPDX-License-Identifier: MIT
#include "cageproof/validation/error_fields.h"

#include "cageproof/core/cage/embedded_cages.h"
#include "cageproof/core/input_error.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>

namespace cageproof::validation {
namespace {

std::vector<double> sorted_difference(const char* evaluation) {
  const auto cage = std::make_shared<const Cage>(embedded_cage("twisted-bar"));
  auto values = sampled(coordinate_difference_field(cage, *find_coordinate_kind("quad_mean_value"), evaluation,
                                                    "closed_form", Triangulation::Shortest, 9),
                        0)
                    .arrays.front()
                    .values;
  std::ranges::sort(values);
  return values;
}

TEST(coordinate_difference_field, shows_what_the_scheme_is_off_by_and_nothing_of_the_line_form) {
  EXPECT_LT(sorted_difference("line-12").back(), 1e-11);
  const auto coarse = sorted_difference("riemann-4"), fine = sorted_difference("riemann-40");
  const std::size_t median = coarse.size() / 2;
  EXPECT_GT(coarse[median], 1e-5);
  EXPECT_LT(coarse.back(), 0.1);
  EXPECT_LT(fine[median], coarse[median] / 10);
}

// On the unit square the weights of its corners add up to one inside, and nothing is shown outside.
TEST(coordinate_field, shows_a_coordinate_inside_the_cage_alone) {
  const auto cage = std::make_shared<const Cage>(embedded_cage("square"));
  const CoordinateKind& kind = *find_coordinate_kind("mean_value");
  std::vector<ImageField> fields;
  fields.reserve(4);
  for (int k = 0; k < 4; ++k) fields.push_back(sampled(coordinate_field(cage, kind, "lambda", k, 12), 1));
  EXPECT_TRUE(fields[0].arrays[0].linear);
  EXPECT_EQ(fields[2].arrays[0].name, "lambda_2");
  int inside = 0;
  for (int i = 0; i < 144; ++i) {
    double sum = 0;
    for (const ImageField& field : fields) sum += field.arrays[0].values[i];
    const bool on_rim = i / 12 == 0 || i / 12 == 11 || i % 12 == 0 || i % 12 == 11;
    EXPECT_EQ(std::isnan(sum), on_rim) << i;
    if (on_rim) continue;
    ++inside;
    EXPECT_NEAR(sum, 1, 1e-14);
  }
  EXPECT_EQ(inside, 100);
  EXPECT_THROW(sampled(coordinate_field(cage, kind, "alpha", 0, 12), 1), InputError);
  EXPECT_THROW(sampled(coordinate_field(cage, kind, "lambda", 4, 12), 1), InputError);
}

TEST(formula_error_field, takes_elements_of_the_formulas_kind) {
  for (const char* name : {"triangle.double_layer", "quad.mean_value"}) {
    const Formula& formula = formula_named(name);
    const ElementSlice one = slice_of(formula.element, 7);
    ASSERT_EQ(static_cast<int>(one.corners.size()), formula.corners());
    const auto recommended = *EvaluationRegister::instance().with_role(name, Role::Recommended);
    const ImageField field = formula_error_field({one.corners}, formula, recommended, 0, one.slice, 0);
    ASSERT_EQ(field.arrays[1].values.size(), 49u);
    for (const double error : field.arrays[1].values) EXPECT_LT(error, 1e-9) << name;
    EXPECT_THROW(formula_error_field({{one.corners[0], one.corners[1]}}, formula, recommended, 0, one.slice, 0),
                 InputError);
  }
}

TEST(formula_error_field, shows_an_evaluation_that_is_wrong) {
  const Formula& formula = formula_named("quad.mean_value");
  const ElementSlice one = slice_of(formula.element, 7);
  const auto field =
      formula_error_field({one.corners}, formula, evaluation_named(formula.name, "riemann-4"), 0, one.slice, 0);
  EXPECT_GT(*std::ranges::max_element(field.arrays[1].values), 1e-3);
}

// True harmonic coordinates of a rectangle are bilinear.
TEST(scheme_error_field, is_what_the_scheme_is_off_by_inside) {
  const auto cage = std::make_shared<const Cage>(embedded_cage("square"));
  const CoordinateKind& kind = coordinate_kind_named("harmonic");
  const CageCoordinates harmonic(*cage, kind, CoordinateOptions{});
  const ImageField field = sampled(scheme_error_field(cage, kind, Triangulation::Shortest, 6), 1);
  const Vec3<double> low = cage->vertices()[0], size = cage->vertices()[2] - low;
  int inside = 0;
  for (int i = 0; i < 36; ++i) {
    const Vec3<double> p = field.origin + field.spacing.cwiseProduct(
                                              Vec3<double>(static_cast<double>(i % 6), static_cast<double>(i / 6), 0));
    const double u = (p[0] - low[0]) / size[0], v = (p[1] - low[1]) / size[1], found = field.arrays[0].values[i];
    if (std::min(u, v) < 0 || std::max(u, v) > 1) {
      EXPECT_TRUE(std::isnan(found)) << i;
      continue;
    }
    const std::array expected{(1 - u) * (1 - v), u * (1 - v), u * v, (1 - u) * v};
    double worst = 0;
    for (std::size_t k = 0; k < 4; ++k)
      worst = std::max(worst, std::abs(harmonic.at<double>(p, 0)[0].value[k] - expected[k]));
    EXPECT_NEAR(found, worst, 1e-10) << i;
    EXPECT_GT(worst, 1e-6) << i;
    ++inside;
  }
  EXPECT_EQ(inside, 16);
}

TEST(scheme_error_field, refuses_kinds_that_approximate_none_and_cages_without_truth) {
  const auto square = std::make_shared<const Cage>(embedded_cage("square")),
             cube = std::make_shared<const Cage>(embedded_cage("cube"));
  const auto rule = Triangulation::Shortest;
  EXPECT_THROW(scheme_error_field(square, coordinate_kind_named("cauchy"), rule, 3), InputError);
  EXPECT_THROW(scheme_error_field(cube, coordinate_kind_named("harmonic"), rule, 3), InputError);
}

TEST(error_fields, say_what_they_are) {
  const auto cage = std::make_shared<const Cage>(embedded_cage("cube"));
  const CoordinateKind& kind = *find_coordinate_kind("green");
  const auto rule = Triangulation::Fan;
  for (const FieldPlan& plan :
       {reproduction_field(cage, kind, "gauss-4", rule, 3), coordinate_error_field(cage, kind, "gauss-4", rule, 3),
        coordinate_difference_field(cage, kind, "gauss-4", "closed_form", rule, 3)}) {
    const FieldFacts& facts = plan.field.facts;
    EXPECT_EQ(facts.at("cage"), "cube") << plan.field.name;
    EXPECT_EQ(facts.at("kind"), "green") << plan.field.name;
    EXPECT_EQ(facts.at("evaluation"), "gauss-4") << plan.field.name;
    EXPECT_EQ(facts.at("triangulation"), "fan") << plan.field.name;
    EXPECT_FALSE(facts.at("unit of length").empty()) << plan.field.name;
    EXPECT_EQ(facts.contains("compared with"), plan.field.name.ends_with("difference")) << plan.field.name;
    EXPECT_EQ(sampled(plan, 1).facts, facts);
  }
  const Formula& formula = formula_named("triangle.double_layer");
  const ElementSlice one = slice_of(formula.element, 3);
  const FieldFacts facts =
      formula_error_field({one.corners}, formula, evaluation_named(formula.name, "gauss-4"), 1, one.slice, 0).facts;
  EXPECT_EQ(facts.at("formula"), "triangle.double_layer");
  EXPECT_EQ(facts.at("evaluation"), "gauss-4");
  EXPECT_EQ(facts.at("order"), "1");
  EXPECT_TRUE(facts.at("truth").ends_with(" in 50 digits"));
}

TEST(elements_of, are_quads_as_they_are_or_split) {
  const Cage cage = embedded_cage("l-block");  // 8 quads, 4 triangles
  EXPECT_EQ(elements_of(cage, ElementKind::Quad, Triangulation::Shortest).size(), 8u);
  EXPECT_EQ(elements_of(cage, ElementKind::Triangle, Triangulation::Shortest).size(), 20u);
  EXPECT_EQ(elements_of(embedded_cage("square"), ElementKind::Segment, Triangulation::Shortest).size(), 4u);
  EXPECT_THROW(elements_of(cage, ElementKind::Segment, Triangulation::Shortest), InputError);
}

TEST(field_measurement, finds_in_blocks_what_sampling_all_finds) {
  const auto cage = std::make_shared<const Cage>(embedded_cage("cube"));
  const auto plan = reproduction_field(cage, *find_coordinate_kind("green"), "gauss-4", Triangulation::Shortest, 31);
  Measurements measurements;
  measurements.push_back(field_measurement(plan, 3, "title", "partition of unity"));
  EXPECT_GT(measurements[0]->blocks(), 3);
  const FieldPart field = whole_fields(measure_all(measurements, 3)).at(3);
  const ImageField expected = sampled(plan, 1);
  for (int a = 0; a < 2; ++a) {
    ASSERT_EQ(field.image.arrays[a].values.size(), 31u * 31u);
    for (std::size_t i = 0; i < 31 * 31; ++i)
      ASSERT_EQ(std::bit_cast<std::uint64_t>(field.image.arrays[a].values[i]),
                std::bit_cast<std::uint64_t>(expected.arrays[a].values[i]))
          << i;
  }
}

}  // namespace
}  // namespace cageproof::validation
