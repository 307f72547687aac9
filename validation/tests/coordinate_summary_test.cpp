// SPDX-License-Identifier: MIT
// Summaries of coordinates count points and flaws of their coordinates, in tables that are spoilt on
// purpose.
#include "cageproof/validation/coordinate_summary.h"

#include "cageproof/core/cage/embedded_cages.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace cageproof::validation {
namespace {

using Vec = Vec3<double>;
constexpr double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();

struct Summarised {
  explicit Summarised(const std::string& name, int highest = 0) : kind(coordinate_kind_named(name)), order(highest) {
    for (const Vec& point : points)
      for (const Result<double>& block : coordinates.at(point, order))
        for (int o = 0; o <= order; ++o) table.insert(table.end(), block.of(o).begin(), block.of(o).end());
  }
  CoordinateSummary summary(int jobs = 1) const { return summary_of(coordinates, cage, points, table, jobs); }
  // A number in a point's row.
  double& at(std::size_t point, std::size_t column) { return table[point * (table.size() / points.size()) + column]; }

  const Cage cage = embedded_cage("cube");
  const CoordinateKind& kind;
  const int order;
  const CageCoordinates coordinates{cage, kind, CoordinateOptions{}};
  // Inside, inside, on a face, on a vertex, outside, inside.
  std::vector<Vec> points{{.1, .2, .3}, {0, 0, 0}, {.5, .125, -.25}, {.5, .5, .5}, {2, 0, 0}, {-.3, .1, .2}};
  std::vector<double> table;
};

TEST(CoordinateSummary, counts_where_points_lie) {
  for (const std::string kind : {"green", "mean_value"}) {
    const CoordinateSummary found = Summarised(kind).summary();
    EXPECT_EQ(found.points, 6U);
    EXPECT_EQ(found.inside, 3U);
    EXPECT_EQ(found.on, 2U);
    EXPECT_EQ(found.outside, 1U);
    EXPECT_TRUE(found.reproduces);
    EXPECT_EQ(found.missing + found.infinite + found.inexact, 0U);
    EXPECT_LT(found.partition.value, 1e-13);
    EXPECT_LT(found.reproduction.value, 1e-13);
    // A mesh collapses outside, except with normalised kinds.
    EXPECT_EQ(found.unusable, kind == "green" ? 1U : 0U);
  }
}

TEST(CoordinateSummary, what_is_not_finite_counts_once_and_has_no_residual) {
  Summarised s("mean_value");
  s.at(0, 3) = nan;
  s.at(0, 4) = inf;
  s.at(5, 0) = -inf;
  const CoordinateSummary found = s.summary();
  EXPECT_EQ(found.missing, 1U);
  EXPECT_EQ(found.infinite, 1U);
  EXPECT_EQ(found.unusable, 2U);
  EXPECT_EQ(found.inexact, 0U);
  EXPECT_LT(found.partition.value, 1e-13);
}

TEST(CoordinateSummary, counts_what_is_inexact_far_from_the_cage) {
  Summarised s("mean_value");
  s.at(1, 0) += 1e-7;
  s.at(5, 7) -= 3e-7;
  EXPECT_EQ(s.summary().inexact_far, 0U);
  s.points[1] = Vec(0, -100, 0);
  EXPECT_EQ(s.summary().inexact, 2U);
  EXPECT_EQ(s.summary().inexact_far, 1U);
}

// A cube of side one so far from the origin: points come back as exactly as doubles are dense there.
TEST(CoordinateSummary, counts_what_an_offset_misplaces) {
  const Cage cube = embedded_cage("cube");
  for (const auto& [offset, expected] :
       {std::pair(1., 0U), std::pair(1e5, 0U), std::pair(3e13, 2U), std::pair(1e15, 2U)}) {
    std::vector<Vec> vertices = cube.vertices();
    for (Vec& v : vertices) v[0] += offset;
    const Cage far = Cage::make("far", vertices, cube.faces());
    const std::vector<Vec> points{{offset + .125, .2, .3}, {offset - .25, .1, .1}};
    const CageCoordinates coordinates(far, coordinate_kind_named("green"), CoordinateOptions{});
    std::vector<double> table;
    for (const Vec& p : points)
      for (const auto& block : coordinates.at<double>(p, 0))
        table.insert(table.end(), block.value.begin(), block.value.end());
    const CoordinateSummary found = summary_of(coordinates, far, points, table, 1);
    EXPECT_EQ(found.misplaced, expected) << offset << ' ' << found.reproduction.value;
    EXPECT_NEAR(found.far_off, offset / far.size(), 1) << offset;
    EXPECT_EQ(found.unusable, 0U);
  }
}

TEST(CoordinateSummary, residuals_are_the_largest_and_name_their_points) {
  Summarised s("mean_value");
  s.at(1, 0) += 1e-7;
  s.at(5, 7) -= 3e-7;
  const CoordinateSummary found = s.summary();
  EXPECT_EQ(found.inexact, 2U);
  EXPECT_NEAR(found.partition.value, 3e-7, 1e-12);
  EXPECT_EQ(found.partition.point, 5U);
  EXPECT_NEAR(found.reproduction.value, 3e-7 * s.cage.vertices()[7].norm() / s.cage.size(), 1e-12);
  EXPECT_EQ(found.reproduction.point, 5U);
  EXPECT_EQ(found.unusable, 0U);
}

// On a vertex green's derivatives have no limit; others are spoilt on purpose. Points without values are counted there.
TEST(CoordinateSummary, counts_points_without_finite_derivatives_and_names_the_first) {
  Summarised s("green", 1);
  const std::size_t gradients = s.coordinates.blocks()[0].size, last = s.table.size() / s.points.size() - 1;
  s.at(1, gradients + 3) = inf;
  s.at(5, last) = nan;
  s.at(4, gradients) = nan;
  for (const int jobs : {1, 4}) {
    const CoordinateSummary found = s.summary(jobs);
    EXPECT_EQ(found.derivatives_on.points, 1U);
    EXPECT_EQ(found.derivatives_on.first, 3U);
    EXPECT_EQ(found.derivatives_missing.points, 2U);
    EXPECT_EQ(found.derivatives_missing.first, 4U);
    EXPECT_EQ(found.derivatives_infinite.points, 1U);
    EXPECT_EQ(found.derivatives_infinite.first, 1U);
    EXPECT_EQ(found.without_derivatives(), 4U);
  }
  s.at(1, 0) = nan;
  EXPECT_EQ(s.summary().derivatives_infinite.points, 0U);
}

TEST(CoordinateSummary, derivatives_between_the_blocks_are_not_looked_at_for_values) {
  const CoordinateSummary values = Summarised("green").summary();
  Summarised s("green", 1);
  // The gradients of phi stand before psi.
  s.at(0, s.coordinates.blocks()[0].size) = nan;
  const CoordinateSummary found = s.summary();
  EXPECT_EQ(found.missing, 0U);
  EXPECT_EQ(found.derivatives_missing.points, 1U);
  EXPECT_NEAR(found.partition.value, values.partition.value, 1e-13);
  EXPECT_NEAR(found.reproduction.value, values.reproduction.value, 1e-13);
  EXPECT_EQ(found.inexact, 0U);
}

TEST(CoordinateSummary, threads_change_nothing_and_of_equals_the_first_point_is_named) {
  Summarised s("mean_value");
  const std::size_t times = 50;
  s.at(2, 1) += 1e-3;
  std::vector<Vec> points;
  std::vector<double> table;
  for (std::size_t i = 0; i < times; ++i) {
    points.insert(points.end(), s.points.begin(), s.points.end());
    table.insert(table.end(), s.table.begin(), s.table.end());
  }
  for (const int jobs : {1, 4}) {
    const CoordinateSummary found = summary_of(s.coordinates, s.cage, points, table, jobs);
    EXPECT_EQ(found.points, 6 * times);
    EXPECT_EQ(found.on, 2 * times);
    EXPECT_EQ(found.inexact, times);
    EXPECT_EQ(found.partition.point, 2U);
    EXPECT_EQ(found.reproduction.point, 2U);
  }
}

TEST(CoordinateSummary, of_no_points_is_empty) {
  const Summarised s("green");
  const CoordinateSummary found = summary_of(s.coordinates, s.cage, {}, {}, 1);
  EXPECT_EQ(found.points, 0U);
  EXPECT_EQ(found.unusable, 0U);
}

}  // namespace
}  // namespace cageproof::validation
