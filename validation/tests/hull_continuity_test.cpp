// SPDX-License-Identifier: MIT
// The check hull_jump asks each of 64 points on the hulls of three twisted quads, and stores none.
#include "checks/hull_continuity.h"

#include "cageproof/validation/measurement.h"

#include <gtest/gtest.h>

namespace cageproof::validation {
namespace {

TEST(hull_continuity, asks_every_point_of_three_hulls_in_both_orders) {
  const Measurements measurements = hull_measurements("*", 1);
  ASSERT_EQ(measurements.size(), 2u);
  const auto rows = measure_all(measurements, 1).rows;
  ASSERT_EQ(rows.size(), 4u);
  for (const auto& [key, tally] : rows) {
    EXPECT_EQ(key.check, "hull_jump");
    EXPECT_EQ(key.setting, hull_regime);
    EXPECT_TRUE(key.order == 0 || key.order == 1);
    EXPECT_EQ(tally.unit, "relative");
    EXPECT_EQ(tally.asked, 3 * 64u);
    EXPECT_EQ(tally.errors.count(), 3 * 64u);
    EXPECT_EQ(tally.max_relative, tally.errors.max());
    EXPECT_TRUE(tally.worst.cases().empty());
    // Values are continuous; the paper's scheme has a derivative that jumps.
    EXPECT_LT(tally.errors.max(), key.order == 0 || key.evaluation == "line_form" ? 1e-6 : 1.0);
  }
}

}  // namespace
}  // namespace cageproof::validation
