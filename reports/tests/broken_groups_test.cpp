// SPDX-License-Identifier: MIT
#include "cageproof/reports/broken_groups.h"

#include <gtest/gtest.h>

namespace cageproof::reports {
namespace {

ResultRow broken(const char* subject, const char* regime, const char* check, double error, const Vec3<double>& point) {
  ResultRow row;
  row.subject = subject;
  row.evaluation = "closed_form";
  row.scalar = "double";
  row.setting = regime;
  row.check = check;
  row.unit = "conditioned";
  row.samples = row.asked = 20;
  row.max = error;
  row.bound = 64;
  row.reason = "a few roundings";
  row.verdict = Verdict::Broken;
  WorstCase worst;
  worst.error = error;
  worst.corners = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  worst.point = point;
  row.worst = {worst};
  return row;
}

RunResult run() {
  RunResult result;
  result.rows = {broken("triangle.double_layer", "near-edge", "truth", 300, {0.1234567890123, 0.1, 1e-9}),
                 broken("triangle.solid_angle", "near-line", "truth", 100, {0.25, 0.5, 0}),
                 broken("triangle.solid_angle", "near-edge", "truth", 1e9, {0.3333333333333333, 0.1, 1e-17}),
                 broken("triangle.single_layer", "near-edge", "scaling", 1e20, {0.1, 0.2, 0.3}),
                 broken("triangle.solid_angle", "near-edge", "integral", 65, {0.1, 0.2, 0.3})};
  result.rows[4].is_foundation = true;
  return result;
}

TEST(broken_groups, stand_in_the_order_in_which_to_look_at_them) {
  const RunResult result = run();
  const auto groups = broken_groups(result);
  ASSERT_EQ(groups.size(), 3u);
  EXPECT_EQ(groups[0].rows.front()->check, "integral");
  EXPECT_EQ(groups[1].rows.size(), 3u);
  EXPECT_EQ(groups[1].rows.front()->max, 1e9);
  EXPECT_EQ(groups[2].rows.front()->check, "scaling");
  EXPECT_EQ(title_of(groups[1]),
            "truth of closed_form in double: 3 rows of triangle.solid_angle, triangle.double_layer; near-edge, "
            "near-line; order 0");
}

TEST(broken_groups, name_their_simplest_input) {
  RunResult result = run();
  // Simple, but kept.
  WorstCase kept = result.rows[0].worst[0];
  kept.error = 3;
  kept.point = {0, 0, 1};
  result.rows[0].worst.push_back(kept);
  const auto groups = broken_groups(result);
  ASSERT_TRUE(groups[1].simplest);
  EXPECT_EQ(groups[1].simplest_row->setting, "near-line");
  EXPECT_EQ(input_line(*groups[1].simplest), "(0, 0, 0) (1, 0, 0) (0, 1, 0) seen from (0.25, 0.5, 0)");
}

TEST(broken_groups, say_what_is_broken_and_nothing_that_is_kept) {
  ResultRow row = broken("triangle.solid_angle", "near-line", "truth", 100, {0.25, 0.5, 0});
  EXPECT_EQ(breach(row), "100 conditioned > 64, a few roundings");
  row.max = 0.573;
  row.reason = "21 of 231 samples are lost: 21 were declined";
  EXPECT_EQ(breach(row), row.reason);
  row.samples = 0;
  row.max = 0;
  EXPECT_EQ(breach(row), row.reason);
}

}  // namespace
}  // namespace cageproof::reports
