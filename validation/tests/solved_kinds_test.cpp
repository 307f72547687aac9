// SPDX-License-Identifier: MIT
// Kinds that are solved once per cage, judged like all others.
#include "cageproof/core/cage/embedded_cages.h"
#include "cageproof/validation/cage_campaign.h"
#include "cageproof/validation/promise.h"

#include <gtest/gtest.h>

#include <set>

namespace cageproof::validation {
namespace {

std::vector<ResultRow> rows_of(const char* kind) {
  CageCampaignOptions options;
  options.kinds = kind;
  options.points = 40;
  options.truth_points = 2;
  options.jobs = 1;
  return run_cage_campaign(embedded_cage("square"), options);
}

}  // namespace

TEST(goursat_kinds, keep_their_promises_inside_and_are_not_asked_outside) {
  for (const char* kind : {"biharmonic_goursat", "harmonic_goursat"}) {
    std::set<std::pair<std::string, int>> kept;
    for (const ResultRow& row : rows_of(kind)) {
      EXPECT_NE(row.verdict, Verdict::Broken) << row.check << ' ' << row.place << ' ' << row.max;
      EXPECT_NE(row.place, "outside") << row.check;
      EXPECT_EQ(row.unreached, 0) << row.check;
      if (row.verdict == Verdict::Kept) kept.emplace(row.check, row.order);
    }
    for (const char* check :
         {"boundary_residual", "partition_of_unity", "linear_reproduction", "limit_from_inside", "cage_scaling"})
      EXPECT_TRUE(kept.contains({check, 0})) << kind << ' ' << check;
    EXPECT_EQ(kept.contains({"boundary_residual", 1}), std::string_view(kind) == "biharmonic_goursat");
    EXPECT_TRUE(kept.contains({"cage_differences", 2})) << kind;
  }
}

TEST(elastic_kind, keeps_its_promises_everywhere) {
  std::set<std::pair<std::string, int>> kept;
  for (const ResultRow& row : rows_of("elastic")) {
    EXPECT_NE(row.verdict, Verdict::Broken) << row.check << ' ' << row.place << ' ' << row.max;
    if (row.verdict == Verdict::Kept) kept.emplace(row.check, row.order);
  }
  for (const char* check : {"partition_of_unity", "linear_reproduction", "zero_outside", "limit_from_inside",
                            "cage_scaling", "cage_rigid_motion", "cage_truth", "second_route"})
    EXPECT_TRUE(kept.contains({check, 0})) << check;
  EXPECT_TRUE(kept.contains({"cage_differences", 2}));
}

// A residual above the solver's tolerance breaks its promise.
TEST(goursat_kinds, promise_their_tolerance) {
  const auto bound = [](const char* cage, int order) {
    return promise_for({"boundary_residual", "biharmonic_goursat", "least_squares", "double", cage, order}).bound;
  };
  EXPECT_EQ(bound("square", 0), 1e-10);
  EXPECT_EQ(bound("l-shape", 1), 1e-9);
  EXPECT_FALSE(bound("comb", 0));
}

}  // namespace cageproof::validation
