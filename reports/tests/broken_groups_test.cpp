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

TEST(broken_groups, of_cages_have_the_cage_its_kinds_and_places_for_a_title) {
  RunResult result;
  const char* kinds[] = {"k1", "k2", "k3", "k4", "k5", "k6", "k7", "k8"};
  for (const char* kind : kinds) {
    ResultRow row = broken(kind, "torus", "partition_of_unity", 300, {0, 0, 0});
    row.section = RowKey::Section::Cage;
    row.place = kind == kinds[0] ? "inside" : "on-face";
    row.order = 1;
    result.rows.push_back(row);
  }
  // One row is of another cage, and one of a deformer in the same cage.
  result.rows.push_back(result.rows[0]);
  result.rows.back().setting = "cube";
  result.rows.push_back(result.rows[0]);
  result.rows.back().section = RowKey::Section::Deformer;
  const auto groups = broken_groups(result);
  ASSERT_EQ(groups.size(), 3u);
  EXPECT_EQ(title_of(groups[0]),
            "partition_of_unity of closed_form in double: 8 rows of k1, k2, k3, k4, k5, k6 and 2 more; cage torus, "
            "inside, on-face; order 1");
  EXPECT_EQ(title_of(groups[1]),
            "partition_of_unity of closed_form in double: 1 row of k1; cage cube, inside; order 1");
  EXPECT_EQ(title_of(groups[2]),
            "partition_of_unity of closed_form in double: 1 row of k1; cage torus, inside; order 1");
  // Six are named, and none is left out.
  result.rows.erase(result.rows.begin() + 6, result.rows.end());
  EXPECT_NE(title_of(broken_groups(result)[0]).find("6 rows of k1, k2, k3, k4, k5, k6; cage"), std::string::npos);
}

TEST(broken_groups, write_inputs_with_all_that_they_hold) {
  WorstCase input;
  input.point = {0.25, -1, 1e-17};
  EXPECT_EQ(input_line(input), "at (0.25, -1, 1e-17)");
  input.frame = {{1, 2, 3}, 1e-8};
  input.parameters = {0.5, 4};
  EXPECT_EQ(input_line(input),
            "at (0.25, -1, 1e-17), the cage moved by (1, 2, 3) and in units of 1e-08, parameters 0.5, 4");
  input.frame = {};
  input.corners = {{0, 0, 1}, {2, 0, 0}};
  EXPECT_EQ(input_line(input), "(0, 0, 1) (2, 0, 0) seen from (0.25, -1, 1e-17), parameters 0.5, 4");
}

TEST(broken_groups, say_where_once_and_leave_out_names_that_rows_lack) {
  ResultRow row = broken("mean_value", "cube", "deformer_jacobian", 100, {0.25, 0.5, 0});
  row.section = RowKey::Section::Deformer;
  row.evaluation = "";
  row.place = "bent";
  WorstCase input;
  input.error = 96;
  input.point = {0.25, -1, 0};
  EXPECT_EQ(error_line(row, input), "96 conditioned at (0.25, -1, 0)");
  input.corners = {{0, 0, 1}, {2, 0, 0}};
  EXPECT_EQ(error_line(row, input), "96 conditioned at (0, 0, 1) (2, 0, 0) seen from (0.25, -1, 0)");
  RunResult result;
  result.rows = {row};
  EXPECT_EQ(title_of(broken_groups(result)[0]),
            "deformer_jacobian in double: 1 row of mean_value; cage cube, bent; order 0");
}

// An error equal to its bound is kept. The first of several inputs of the same length stands.
TEST(broken_groups, name_no_input_of_what_keeps_its_bound) {
  RunResult result = run();
  result.rows.resize(1);
  result.rows[0].worst[0].error = 64;
  EXPECT_FALSE(broken_groups(result)[0].simplest);
  result.rows[0].worst.push_back(result.rows[0].worst[0]);
  for (WorstCase& worst : result.rows[0].worst) worst.error = 65;
  const auto groups = broken_groups(result);
  EXPECT_EQ(groups[0].simplest, &result.rows[0].worst[0]);
  EXPECT_EQ(groups[0].simplest_row, &result.rows[0]);
}

TEST(broken_groups, say_what_is_broken_and_nothing_that_is_kept) {
  ResultRow row = broken("triangle.solid_angle", "near-line", "truth", 100, {0.25, 0.5, 0});
  EXPECT_EQ(breach(row), "100 conditioned > 64, a few roundings");
  row.max = 0.573;
  row.reason = "21 of 231 samples are lost: 21 were declined";
  EXPECT_EQ(breach(row), row.reason);
  row.max = 64;
  EXPECT_EQ(breach(row), row.reason) << "what is as bad as its bound allows keeps it";
  row.samples = 0;
  row.max = 0;
  EXPECT_EQ(breach(row), row.reason);
}

}  // namespace
}  // namespace cageproof::reports
