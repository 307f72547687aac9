// SPDX-License-Identifier: MIT
// What a run measures, from its options alone: which cages get error fields.
#include "run/run_plan.h"

#include "cageproof/core/cage/embedded_cages.h"
#include "cageproof/core/input_error.h"

#include <gtest/gtest.h>

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

TEST(RunPlan, quick_leaves_out_the_fields_of_larger_embedded_cages_and_says_so) {
  VerifyOptions options;
  options.suite = suites().front();
  const RunPlan quick = plan_run(options);
  EXPECT_GT(fields_of(quick, "cube"), 0);
  EXPECT_EQ(notes_on(quick, "cube"), 0);
  for (const char* cage : {"torus", "spiky-box", "icosphere"}) {
    EXPECT_EQ(fields_of(quick, cage), 0) << cage;
    EXPECT_EQ(notes_on(quick, cage), 1) << cage;
  }
  options.suite = suites()[1];
  const RunPlan standard = plan_run(options);
  for (const char* cage : {"cube", "torus", "spiky-box", "icosphere"}) {
    EXPECT_GT(fields_of(standard, cage), 0) << cage;
    EXPECT_EQ(notes_on(standard, cage), 0) << cage;
  }
}

// What the cage's coordinates do not sum says nothing of it.
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

int measured(const RunPlan& plan, const std::string& part) {
  return static_cast<int>(std::ranges::count_if(
      plan.measurements, [&](const auto& measurement) { return measurement->name().find(part) != std::string::npos; }));
}

// What promises nothing and is slow by nature.
TEST(RunPlan, quick_leaves_slow_rows_and_fields_without_promise_to_standard_and_to_users_cages) {
  VerifyOptions options;
  options.suite = suites().front();
  const RunPlan quick = plan_run(options);
  options.suite = suites()[1];
  const RunPlan standard = plan_run(options);
  const std::vector<std::string> slow{"cube, quad_green, adaptive", "field cube.quad_green.line_form.error",
                                      "star, biharmonic_boundary, offset-1e-6"};
  for (const std::string& part : slow) {
    EXPECT_EQ(measured(quick, part), 0) << part;
    EXPECT_EQ(measured(standard, part), 1) << part;
  }
  // Promised, or quick.
  for (const char* part : {"cube, quad_mean_value, adaptive", "cube, quad_mean_value, multiprecision",
                           "field cube.green.hybrid.error", "star, biharmonic_boundary, "})
    EXPECT_GE(measured(quick, part), 1) << part;
  EXPECT_EQ(std::ranges::count(quick.header.notes,
                               "cube: error fields of coordinates that keep its quads are drawn by longer suites"),
            1);
  options.suite = suites().front();
  options.cage = embedded_cage("star");
  EXPECT_EQ(measured(plan_run(options), "star, biharmonic_boundary, offset-1e-6"), 1);
}

}  // namespace
}  // namespace cageproof::validation
