// SPDX-License-Identifier: MIT
// Harmonic coordinates in space as `verify` asks them: promises, and a route that shares only the layers.
#include "cageproof/core/cage/embedded_cages.h"
#include "cageproof/core/coordinates/coordinates.h"
#include "cageproof/validation/cage_campaign.h"

#include <gtest/gtest.h>

#include <map>

namespace cageproof::validation {
namespace {

TEST(harmonic_in_space, keep_their_promises) {
  CageCampaignOptions options;
  options.kinds = "harmonic";
  options.points = 40;
  options.truth_points = 2;
  options.on_points = 16;
  options.signs = true;
  std::map<std::string, int> rows;
  for (const ResultRow& row : run_cage_campaign(embedded_cage("cube"), options)) {
    ++rows[row.check];
    EXPECT_NE(row.verdict, Verdict::Broken) << row.check << ' ' << row.place << ' ' << row.order << ": " << row.max;
    // The scheme's own error, a part of one, and in roundings.
    if (row.check == "boundary_data") EXPECT_LT(row.max, 3e-2);
    if (row.check == "non_negativity") EXPECT_LT(row.max, 3e-3 * 0x1p53);
  }
  for (const char* check :
       {"partition_of_unity", "linear_reproduction", "zero_outside", "cage_truth", "cage_laplacian", "cage_scaling",
        "cage_rigid_motion", "limit_from_inside", "boundary_data", "second_route", "cage_differences"})
    EXPECT_GT(rows[check], 0) << check;
}

}  // namespace
}  // namespace cageproof::validation
