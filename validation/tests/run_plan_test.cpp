// SPDX-License-Identifier: MIT
// What a run measures, from its options alone: which cages get error fields.
#include "run_plan.h"

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

}  // namespace
}  // namespace cageproof::validation
