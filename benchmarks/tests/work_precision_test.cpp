// SPDX-License-Identifier: MIT
#include "cageproof/core/cage/embedded_cages.h"
#include "cageproof/core/input_error.h"
#include "cageproof/benchmarks/work_precision.h"
#include "summarise.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>

namespace cageproof::benchmarks {

using namespace validation;
namespace {

constexpr double known_error = 1e-3;
constexpr double known_nanoseconds = 2e5;

// Seven nodes, a thousandth too large, and at least 0.2 ms.
void fill_fake(Evaluation& bad) {
  const Evaluation good = evaluation_named("triangle.double_layer", "closed_form");
  bad.set_point<double>([good](const Query<double>& query, Result<double>& result) {
    const auto start = std::chrono::steady_clock::now();
    good(query, result);
    for (double& x : result.value) x *= 1 + known_error;
    result.nodes = 7;
    const std::chrono::nanoseconds least(static_cast<int>(known_nanoseconds));
    while (std::chrono::steady_clock::now() - start < least) continue;
  });
}
const RegisterEvaluation fake{single_family(
    "triangle.double_layer", "seven-nodes",
    {.description = "wrong by a known amount, and slow", .role = Role::Foreign, .max_order = 0}, false, fill_fake)};

// As slow where the point lies in one of about `1 / slow_share` slices of space, and quick elsewhere.
constexpr double slow_share = 1.0 / 16;
void fill_sometimes_slow(Evaluation& bad) {
  const Evaluation good = evaluation_named("triangle.double_layer", "seven-nodes");
  bad.set_point<double>([good](const Query<double>& query, Result<double>& result) {
    const double slice = 1e3 * query.point[0];
    if (slice - std::floor(slice) < slow_share) good(query, result);
    else result.reset(3, 3, 0);
  });
}
const RegisterEvaluation sometimes{
    single_family("triangle.double_layer", "sometimes-slow",
                  {.description = "slow at a known share of points", .role = Role::Foreign, .max_order = 0}, false,
                  fill_sometimes_slow)};

const CoordinateKind& phi_alone() {
  static const CoordinateKind kind{
      .name = "phi alone", .source = "", .blocks = {{"phi", "double_layer", Reproduces::Vertices}}};
  return kind;
}

WorkPrecisionOptions quick(std::vector<std::string> evaluations) {
  WorkPrecisionOptions options;
  options.evaluations = std::move(evaluations);
  options.samples = 3;
  options.seconds = 0;
  options.jobs = 1;
  return options;
}

std::vector<PointGroup> cube_groups(int count) {
  const Cage cube = embedded_cage("cube");
  return groups_inside(cube, CageLocator(cube, Triangulation::Shortest), 1, count);
}

TEST(work_precision, shows_a_known_error_its_nodes_and_its_time) {
  const auto options = quick({"seven-nodes", "closed_form"});
  const auto result = cage_work_precision(embedded_cage("cube"), phi_alone(), cube_groups(3), options);
  ASSERT_EQ(result.rows.size(), 10u);
  for (const WorkPrecisionRow& row : result.rows) {
    EXPECT_EQ(row.samples, 3u);
    EXPECT_EQ(row.nonfinite, 0u);
    if (row.evaluation == "closed_form") {
      EXPECT_LT(row.largest, 1e-12) << row.place;
      EXPECT_EQ(row.nodes, 0);
      continue;
    }
    // A sum of one, a thousandth too large.
    EXPECT_NEAR(row.largest, known_error, 1e-11) << row.place;
    EXPECT_NEAR(row.rms, known_error, 1e-11) << row.place;
    EXPECT_NEAR(row.median, known_error, 1e-11) << row.place;
    EXPECT_EQ(row.nodes, 7);
    EXPECT_EQ(row.timed, 3U * 12) << "three points, twelve triangles";
    EXPECT_GE(row.median_nanoseconds, known_nanoseconds);
    EXPECT_GE(row.nanoseconds, known_nanoseconds);
    EXPECT_GE(row.quantile_nanoseconds, row.median_nanoseconds);
  }
}

// One pair in so many takes a known time longer, which the quantile shows, the mean shows its share of, and the median
// does not.
TEST(work_precision, times_pairs_one_by_one) {
  WorkPrecisionOptions options = quick({"seven-nodes", "sometimes-slow"});
  options.timed = 1200;
  options.seconds = 60;
  const auto result = formula_work_precision(*find_formula("triangle.double_layer"), {find_regime("generic")}, options);
  ASSERT_EQ(result.rows.size(), 2u);
  const WorkPrecisionRow& row = result.rows[1];
  EXPECT_EQ(row.timed, 1200u);
  EXPECT_LT(row.median_nanoseconds, known_nanoseconds / 2);
  EXPECT_GE(row.quantile_nanoseconds, known_nanoseconds);
  EXPECT_GT(row.nanoseconds, known_nanoseconds * slow_share / 3);
  EXPECT_LT(row.nanoseconds, row.quantile_nanoseconds);
}

TEST(work_precision, quantile_leaves_a_thousandth_out) {
  std::vector<double> times(1000);
  for (std::size_t i = 0; i < times.size(); ++i) times[i] = static_cast<double>(1 + i * 7 % 1000);
  WorkPrecisionRow row;
  summarise_times(times, row);
  EXPECT_EQ(row.timed, 1000u);
  EXPECT_EQ(row.median_nanoseconds, 500);
  EXPECT_EQ(row.nanoseconds, 500.5);
  EXPECT_EQ(row.quantile_nanoseconds, 999);
  summarise_times({3, 1, 2}, row);
  EXPECT_EQ(row.quantile_nanoseconds, 3) << "fewer than a thousand: the longest";
}

// More pieces come nearer to what the scheme approximates, and take longer.
TEST(work_precision, measures_solved_kinds_by_their_pieces) {
  const Cage square = embedded_cage("square");
  const auto groups = groups_inside(square, CageLocator(square, Triangulation::Shortest), 1, 3);
  const auto result = cage_work_precision(square, coordinate_kind_named("biharmonic_boundary"), groups, quick({}));
  EXPECT_EQ(result.timed, "point");
  EXPECT_EQ(result.error, "difference from biharmonic_goursat");
  ASSERT_EQ(result.rows.size(), 6 * groups.size());
  EXPECT_EQ(result.rows[0].evaluation, "pieces=1");
  EXPECT_EQ(result.rows[5].evaluation, "pieces=32");
  EXPECT_EQ(result.rows[0].place, "interior");
  EXPECT_LT(result.rows[5].largest, result.rows[0].largest / 4);
  EXPECT_GT(result.rows[5].largest, 1e-4);
  EXPECT_GT(result.rows[0].nanoseconds, 0);
}

TEST(work_precision, measures_solved_kinds_as_asked) {
  const Cage square = embedded_cage("square");
  const auto groups = groups_inside(square, CageLocator(square, Triangulation::Shortest), 1, 3);
  WorkPrecisionOptions options = quick({});
  options.parameters = {2, 1, 1};
  const auto one = cage_work_precision(square, coordinate_kind_named("harmonic"), groups, options);
  ASSERT_EQ(one.rows.size(), groups.size());
  EXPECT_EQ(one.error, "difference from harmonic_goursat");
  const auto cauchy = cage_work_precision(square, coordinate_kind_named("cauchy"), groups, quick({}));
  EXPECT_EQ(cauchy.error, "partition of unity residual");
  for (const WorkPrecisionRow& row : cauchy.rows) EXPECT_LT(row.largest, 1e-14);
}

// In space there is no truth to compare with but a finer level.
TEST(work_precision, measures_solved_kinds_in_space_by_their_level) {
  const auto result =
      cage_work_precision(embedded_cage("cube"), coordinate_kind_named("harmonic"), cube_groups(3), quick({}));
  EXPECT_EQ(result.error, "difference from level 3");
  ASSERT_EQ(result.rows.size() % 3, 0u);
  EXPECT_EQ(result.rows[0].evaluation, "level=0");
  EXPECT_EQ(result.rows[2].evaluation, "level=2");
  EXPECT_LT(result.rows[2].largest, result.rows[0].largest / 10);
  EXPECT_GT(result.rows[2].largest, 1e-7);
}

TEST(work_precision, measures_relative_and_conditioned_errors_of_a_formula) {
  const auto result = formula_work_precision(*find_formula("triangle.double_layer"), {find_regime("generic")},
                                             quick({"seven-nodes", "closed_form"}));
  ASSERT_EQ(result.rows.size(), 2u);
  // The denominator is at least the value: a relative error of 1e-3 is at most 1e-3 / u, and far more than rounding.
  const double u = unit_roundoff<double>();
  EXPECT_NEAR(result.rows[0].largest, known_error, known_error * 1e-6);
  EXPECT_LE(result.rows[0].units.value(), known_error / u * 1.001);
  EXPECT_GT(result.rows[0].units.value(), known_error / u / 1000);
  EXPECT_GE(result.rows[0].largest, result.rows[0].median);
  EXPECT_LE(result.rows[1].units.value(), 64);
  EXPECT_LE(result.rows[1].largest, 1000 * u);
}

TEST(work_precision, names_every_evaluation_that_is_missing) {
  try {
    cage_work_precision(embedded_cage("cube"), phi_alone(), cube_groups(1),
                        quick({"nonsense", "closed_form", "gauss-0"}));
    FAIL() << "no error";
  } catch (const InputError& e) {
    for (const char* word : {"'nonsense'", "'gauss-0'", "phi alone has no evaluation", "N from 1 to 256"})
      EXPECT_NE(std::string(e.what()).find(word), std::string::npos) << e.what();
  }
  auto options = quick({"seven-nodes"});
  options.order = 1;
  EXPECT_THROW(formula_work_precision(*find_formula("triangle.double_layer"), {find_regime("generic")}, options),
               InputError);
}

TEST(work_precision, points_inside_are_as_far_as_their_group_says) {
  const Cage cube = embedded_cage("cube");
  const CageLocator locator(cube, Triangulation::Shortest);
  const auto groups = cube_groups(20);
  ASSERT_EQ(groups.size(), 5u);
  for (const PointGroup& group : groups) {
    EXPECT_EQ(group.points.size(), 20u) << group.place;
    for (const CagePoint& p : group.points) {
      EXPECT_TRUE(locator.inside(p.point));
      const double distance = locator.distance(p.point) / cube.size();
      EXPECT_GE(distance, 0.999 * group.distance);
      if (group.place != "interior") {
        EXPECT_LE(distance, 1.001 * group.distance);
      }
    }
  }
}

TEST(work_precision, given_points_are_grouped_by_decade) {
  const Cage cube = embedded_cage("cube");
  const CageLocator locator(cube, Triangulation::Shortest);
  std::vector<Vec3<double>> points;
  for (const PointGroup& group : cube_groups(2))
    for (const CagePoint& p : group.points) points.push_back(p.point);
  points.push_back(cube.vertices()[0]);
  points.push_back(Vec3<double>(100, 0, 0));
  std::size_t grouped = 0;
  double last = HUGE_VAL;
  for (const PointGroup& group : groups_of(cube, locator, points)) {
    EXPECT_LT(group.distance, last);
    last = group.distance;
    const int decade = static_cast<int>(std::lround(std::log10(group.distance)));
    EXPECT_EQ(group.place, fmt::format("1e{}..1e{}", decade, decade + 1));
    for (const CagePoint& p : group.points) EXPECT_LT(locator.distance(p.point), 10.001 * group.distance * cube.size());
    grouped += group.points.size();
    for (const CagePoint& p : group.points) EXPECT_EQ(p.place == Place::Outside, p.point[0] == 100);
  }
  EXPECT_EQ(grouped, points.size() - 1);
}

}  // namespace
}  // namespace cageproof::benchmarks
