// SPDX-License-Identifier: MIT
// The plan of a run depends only on its options, which also say which cages get error fields.
#include "run/run_plan.h"

#include "cageproof/core/cage/embedded_cages.h"
#include "cageproof/core/input_error.h"

#include <gtest/gtest.h>

#include <set>

namespace cageproof::validation {
namespace {

int fields_of(const RunPlan& plan, const std::string& cage) {
  return static_cast<int>(std::ranges::count_if(
      plan.measurements, [&](const auto& measurement) { return measurement->name().starts_with("field " + cage); }));
}

int notes_on(const RunPlan& plan, const std::string& cage) {
  return static_cast<int>(std::ranges::count_if(
      plan.header.notes, [&](const std::string& note) { return note.starts_with(cage + ": its error fields"); }));
}

RunPlan plan_of_all(int suite) {
  VerifyOptions options;
  options.suite = suites()[suite];
  return plan_run(options);
}

// Plans of everything; each takes some seconds.
const RunPlan& quick_plan() {
  static const RunPlan plan = plan_of_all(0);
  return plan;
}
const RunPlan& standard_plan() {
  static const RunPlan plan = plan_of_all(1);
  return plan;
}

TEST(RunPlan, quick_leaves_out_the_fields_of_larger_embedded_cages_and_says_so) {
  const RunPlan &quick = quick_plan(), &standard = standard_plan();
  EXPECT_GT(fields_of(quick, "cube"), 0);
  EXPECT_EQ(notes_on(quick, "cube"), 0);
  for (const char* cage : {"torus", "spiky-box", "icosphere"}) {
    EXPECT_EQ(fields_of(quick, cage), 0) << cage;
    EXPECT_EQ(notes_on(quick, cage), 1) << cage;
  }
  for (const char* cage : {"cube", "torus", "spiky-box", "icosphere"}) {
    EXPECT_GT(fields_of(standard, cage), 0) << cage;
    EXPECT_EQ(notes_on(standard, cage), 0) << cage;
  }
}

// Formulas that the cage's coordinates do not sum cannot judge them.
TEST(RunPlan, refuses_a_cage_that_the_formulas_asked_for_do_not_apply_to) {
  VerifyOptions options;
  options.suite = suites().front();
  options.cage = embedded_cage("cube");
  for (const char* formulas : {"segment.single_layer", "segment.*", "triangle.solid_angle"}) {
    options.formulas = formulas;
    EXPECT_THROW(plan_run(options), InputError) << formulas;
  }
  for (const char* formulas : {"*", "segment.single_layer,quad.double_layer", "triangle.single_layer"}) {
    options.formulas = formulas;
    EXPECT_NO_THROW(plan_run(options)) << formulas;
  }
}

// Evaluations, variants and regimes may have no name.
TEST(RunPlan, names_of_measurements_have_no_empty_part) {
  for (const auto& measurement : quick_plan().measurements) {
    EXPECT_EQ(measurement->name().find(", ,"), std::string::npos) << measurement->name();
    EXPECT_FALSE(measurement->name().ends_with(", ")) << measurement->name();
  }
}

int measured(const RunPlan& plan, const std::string& part) {
  return static_cast<int>(std::ranges::count_if(
      plan.measurements, [&](const auto& measurement) { return measurement->name().find(part) != std::string::npos; }));
}

// Slow rows without promises are left out of the quick suite.
TEST(RunPlan, quick_leaves_slow_rows_and_fields_without_promise_to_standard_and_to_users_cages) {
  const RunPlan &quick = quick_plan(), &standard = standard_plan();
  const std::vector<std::string> slow{"cube, quad_green, adaptive", "field cube.quad_green.line_form.error",
                                      "star, biharmonic_boundary, offset-1e-6"};
  for (const std::string& part : slow) {
    EXPECT_EQ(measured(quick, part), 0) << part;
    EXPECT_EQ(measured(standard, part), 1) << part;
  }
  // Promised, or quick.
  for (const char* part : {"cube, quad_mean_value, adaptive", "cube, quad_mean_value, multiprecision",
                           "field cube.green.hybrid.error", "star, biharmonic_boundary"})
    EXPECT_GE(measured(quick, part), 1) << part;
  EXPECT_EQ(std::ranges::count(quick.header.notes,
                               "cube: error fields of coordinates that keep its quads are drawn by longer suites"),
            1);
  VerifyOptions options;
  options.suite = suites().front();
  options.only_cage = true;
  options.cage = embedded_cage("star");
  EXPECT_EQ(measured(plan_run(options), "star, biharmonic_boundary, offset-1e-6"), 1);
}

// After an edit of one formula its verdict does not wait for cages that say the same again.
TEST(RunPlan, asks_a_kind_on_one_cage_unless_all_formulas_of_an_element_are_named) {
  const auto plan_of = [](const std::string& formulas) {
    VerifyOptions options;
    options.suite = suites().front();
    options.formulas = formulas;
    return plan_run(options);
  };
  const RunPlan triangle = plan_of("triangle.double_layer");
  // Quads are cut into triangles, or stay beside triangles.
  for (const char* part : {"cube, green", "cube, biharmonic", "l-block, quad_green", "l-block, quad_biharmonic",
                           "cage_block_error, cube, green", "cube, one ring"})
    EXPECT_GE(measured(triangle, part), 1) << part;
  for (const char* part : {"torus", "icosphere", "spiky-box", "twisted-bar,", "nested", "l-block, green"})
    EXPECT_EQ(measured(triangle, part), 0) << part;
  const RunPlan layers = plan_of("*.double_layer");
  for (const char* part : {"square, green", "cube, green", "cube, quad_green", "l-block, quad_green"})
    EXPECT_GE(measured(layers, part), 1) << part;
  const RunPlan triangles = plan_of("triangle.*");
  for (const char* part : {"torus, green", "nested, green", "torus, one ring"})
    EXPECT_EQ(measured(triangles, part), measured(quick_plan(), part)) << part;
}

// A flat tetrahedron whose densities double has just digits enough for, and not where it is turned: the kind is left
// out, and said.
TEST(RunPlan, leaves_out_kinds_that_refuse_the_cage_when_it_is_turned) {
  VerifyOptions options;
  options.suite = suites().front();
  options.only_cage = true;
  options.cage = Cage::make("flat", {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {.3, .3, 1e-9}},
                            {{{0, 2, 1, -1}}, {{0, 1, 3, -1}}, {{0, 3, 2, -1}}, {{1, 2, 3, -1}}});
  const RunPlan plan = plan_run(options);
  EXPECT_EQ(measured(plan, "flat, regularised_1_2"), 0);
  EXPECT_GE(measured(plan, "flat, regularised_1_3"), 1);
  EXPECT_EQ(std::ranges::count_if(plan.warnings,
                                  [](const std::string& warning) {
                                    return warning.find("no regularised_1_2 coordinates") != std::string::npos &&
                                           warning.find("no digits left of derivatives") != std::string::npos;
                                  }),
            1);
}

// Two cubes that cross: what solves for densities on the cage is left out, and said; a cube that touches another one's
// edge with a corner keeps everything.
TEST(RunPlan, leaves_out_what_a_cage_that_overlaps_itself_has_not) {
  const Cage cube = embedded_cage("cube");
  const auto two_cubes = [&](const Vec3<double>& shift) {
    std::vector<Vec3<double>> vertices = cube.vertices();
    std::vector<Face> faces = cube.faces();
    for (const auto& v : cube.vertices()) vertices.push_back(v + shift);
    for (Face face : cube.faces()) {
      for (int& v : face.vertices) v += 8;
      faces.push_back(face);
    }
    return Cage::make("two cubes", vertices, faces);
  };
  VerifyOptions options;
  options.suite = suites()[1];  // which asks kinds that solve of larger cages, too
  options.only_cage = true;
  const double side = (cube.vertices().back() - cube.vertices().front()).cwiseAbs().maxCoeff();
  options.cage = two_cubes(side * Vec3<double>(0.5, 0.25, 0.125));
  const RunPlan crossing = plan_run(options);
  for (const char* part : {"regularised_1_3", "deformer biharmonic_1_3", "deformer ahap", "deformer tp"})
    EXPECT_EQ(measured(crossing, part), 0) << part;
  for (const char* part : {"two cubes, green", "two cubes, biharmonic", "deformer green", "deformer mean_value"})
    EXPECT_GE(measured(crossing, part), 1) << part;
  // Harmonic and elastic coordinates say it of a triangle, the others of faces.
  ASSERT_EQ(crossing.warnings.size(), 6U);
  for (const char* part : {"regularised_1_3", "ahap, biharmonic_1_2", "no harmonic", "deformer harmonic", "no elastic",
                           "deformer elastic"})
    EXPECT_TRUE(std::ranges::any_of(crossing.warnings, [&](const std::string& warning) {
      return warning.find(part) != std::string::npos;
    })) << part;
  for (const std::string& warning : crossing.warnings) {
    EXPECT_TRUE(warning.find("faces ") != std::string::npos || warning.find("triangle ") != std::string::npos)
        << warning;
    // Elastic coordinates are matrices.
    const bool is_elastic = warning.find("elastic") != std::string::npos;
    EXPECT_NE(warning.find(is_elastic ? "sum to a matrix that is 1 off the identity" : "sum to 2, not to 1"),
              std::string::npos)
        << warning;
  }
  EXPECT_EQ(std::ranges::count(crossing.header.notes, crossing.warnings[1]), 1);
  options.cage = two_cubes(side * Vec3<double>(1, 1, 0.5));
  ASSERT_TRUE(crossing_warning(*options.cage));
  const RunPlan touching = plan_run(options);
  EXPECT_EQ(touching.warnings, std::vector<std::string>());
  EXPECT_GE(measured(touching, "deformer ahap"), 1);
}

// Somebody waits for the verdict on one cage, so that nothing is asked again that is proven on other cages.
TEST(RunPlan, asks_in_a_users_cage_what_depends_on_the_cage) {
  VerifyOptions options;
  options.suite = suites().front();
  options.only_cage = true;
  options.cage = Cage::make("corner", {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {.3, .3, .7}},
                            {{{0, 2, 1, -1}}, {{0, 1, 3, -1}}, {{0, 3, 2, -1}}, {{1, 2, 3, -1}}});
  for (const bool has_time_limit : {true, false}) {
    options.suite.has_time_limit = has_time_limit;
    const RunPlan plan = plan_run(options);
    for (const std::string method : {"biharmonic_1_3", "elastic"}) {
      std::set<std::string> checks;
      for (const auto& measurement : plan.measurements)
        if ((measurement->name() + ", ").starts_with("corner, deformer " + method + ", "))
          for (const auto& [key, tally] : measurement->measure(0).rows) checks.insert(key.check);
      EXPECT_TRUE(checks.contains("keeps_rigid")) << method;
      EXPECT_EQ(checks.contains("deformer_truth"), !has_time_limit || method == "biharmonic_1_3") << method;
      for (const char* check : {"second_route", "deformer_by_quadrature"})
        EXPECT_EQ(checks.contains(check), !has_time_limit && method == "biharmonic_1_3") << method << ' ' << check;
    }
  }
}

TEST(RunPlan, counts_the_points_that_lie_outside_the_cage) {
  VerifyOptions options;
  options.suite = suites().front();
  options.only_cage = true;
  options.cage = embedded_cage("cube");
  options.mesh_name = "poking.obj";
  // On the cage counts as inside.
  options.mesh = Mesh{.vertices = {{0, 0, 0}, options.cage->vertices()[0], {5, 0, 0}, {0, 0, -7}}, .faces = {}};
  for (const char* evaluations : {"*", "batched"}) {
    options.evaluations = evaluations;
    const RunPlan plan = plan_run(options);
    EXPECT_EQ(plan.points_outside, 2u);
    EXPECT_EQ(plan.header.settings.at("points outside"), "2 of 4");
    ASSERT_EQ(plan.warnings.size(), 1u);
    EXPECT_EQ(plan.warnings[0].find("2 of 4 points of poking.obj are outside cube, the first of them number 2"), 0u);
    EXPECT_EQ(std::ranges::count(plan.header.notes, plan.warnings[0]), 1);
  }
  options.mesh->vertices.resize(2);
  const RunPlan plan = plan_run(options);
  EXPECT_EQ(plan.points_outside, 0u);
  EXPECT_FALSE(plan.header.settings.contains("points outside"));
  EXPECT_EQ(plan.warnings, std::vector<std::string>());
}

}  // namespace
}  // namespace cageproof::validation
