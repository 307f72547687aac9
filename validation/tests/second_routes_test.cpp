// SPDX-License-Identifier: MIT
// Second routes of kinds: known integrals, agreement with the first route, and a disagreement that is seen.
#include "cageproof/core/cage/embedded_cages.h"
#include "cageproof/validation/cage_campaign.h"
#include "cageproof/validation/promise.h"
#include "cages/second_route_error.h"
#include "second_routes/boundary_route.h"
#include "second_routes/entropy_route.h"
#include "second_routes/spherical_route.h"

#include <gtest/gtest.h>

#include <limits>

namespace cageproof::validation::second_routes_test {
namespace {

std::vector<ResultRow> second_route_rows(const std::string& kind, const std::string& cage) {
  CageCampaignOptions options;
  options.kinds = kind;
  options.points = 40;
  options.truth_points = 1;
  options.differences = false;
  options.jobs = 1;
  std::vector<ResultRow> rows = run_cage_campaign(embedded_cage(cage), options);
  std::erase_if(rows, [](const ResultRow& row) { return row.check != "second_route"; });
  return rows;
}

double distance(const Mp100& found, const Mp100& expected) { return static_cast<double>(Mp100(abs(found - expected))); }

}  // namespace

// Over an octant each coordinate's integral is a quarter of pi, whatever axis the fan has.
TEST(second_routes, integrate_the_position_over_spherical_polygons) {
  using Vec = Vec3<Mp100>;
  const Mp100 quarter = MpConstants<100>::pi() / 4;
  const std::vector<Vec> octant{Vec::Unit(0), Vec::Unit(1), Vec::Unit(2)};
  const Vec found = second_routes::mean_vector(octant);
  for (int c = 0; c < 3; ++c) EXPECT_LT(distance(found[c], quarter), 1e-40);
  // A half of the sphere, its border in four arcs: its projection's area.
  const std::vector<Vec> half{Vec::Unit(0), Vec::Unit(1), -Vec::Unit(0), -Vec::Unit(1)};
  EXPECT_LT(distance(second_routes::mean_vector(half)[2], 4 * quarter), 1e-40);
}

TEST(second_routes, share_out_directions_by_half_tangents) {
  using Vec = Vec3<Mp100>;
  const std::vector<Vec> square{Vec::Unit(0), Vec::Unit(1), -Vec::Unit(0), -Vec::Unit(1)};
  for (const Mp100& share : second_routes::shares_of_directions(square, Vec::Unit(2)))
    EXPECT_LT(distance(share, Mp100(2)), 1e-40);  // twice tan(pi/4)
}

// Four vertices leave no choice, whatever the prior; a cube seen from its centre with one large prior does.
TEST(second_routes, minimise_the_entropy) {
  using second_routes::EntropyProblem;
  const std::vector<Vec3<double>> corners{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {0, 0, 4}};
  const EntropyProblem simplex(corners, {Mp100(5), Mp100(1), Mp100(1), Mp100(1)}, {1, 1, 1}, 4);
  const std::vector<Mp100> found = second_routes::entropy_coordinates(simplex);
  for (const Mp100& lambda : found) EXPECT_LT(distance(lambda, Mp100(0.25)), 1e-75);
  EXPECT_LT(second_routes::unmet_optimality(simplex, found), 1e-75);
  const Cage cube = embedded_cage("cube");
  std::vector<Mp100> prior(8, Mp100(1));
  prior[3] = 7;
  const EntropyProblem problem(cube.vertices(), prior, {0.1, 0, -0.2}, cube.size());
  std::vector<Mp100> lambda = second_routes::entropy_coordinates(problem);
  EXPECT_LT(second_routes::unmet_optimality(problem, lambda), 1e-75);
  // Signs by the parity of a corner: all linear functions sum to zero over them, so that conditions but one are met.
  for (std::size_t i = 0; i < 8; ++i) lambda[i] += (cube.vertices()[i].prod() > 0 ? 1 : -1) * Mp100("1e-20");
  EXPECT_GT(second_routes::unmet_optimality(problem, lambda), 1e-20);
  EXPECT_LT(second_routes::unmet_optimality(problem, lambda), 1e-15);
  lambda[0] = -1;
  EXPECT_EQ(second_routes::unmet_optimality(problem, lambda), std::numeric_limits<double>::infinity());
}

TEST(second_routes, have_no_coordinates_outside_of_the_hull) {
  const Cage cube = embedded_cage("cube");
  const second_routes::EntropyProblem problem(cube.vertices(), std::vector<Mp100>(8, Mp100(1)), {0.75, 0, 0},
                                              cube.size());
  EXPECT_TRUE(isnan(second_routes::entropy_coordinates(problem).front()));
}

TEST(second_routes, reproduce_affine_functions_by_boundary_equations) {
  const Cage cage = embedded_cage("l-shape");
  const CageElements elements(cage, true, Triangulation::Shortest);
  const Vec3<double> point(0.6, 0.7, 0);
  for (const int order : {1, 2, 3}) {
    const auto blocks = second_routes::BoundaryRoute(cage, order).at(point);
    ASSERT_EQ(blocks.size(), order);
    Mp200 ones = -1, along = -Mp200(point[0]);
    for (std::size_t v = 0; v < blocks[0].size(); ++v) {
      ones += blocks[0][v];
      along += blocks[0][v] * cage.vertices()[v][0];
    }
    for (std::size_t e = 0; order > 1 && e < blocks[1].size(); ++e) along += blocks[1][e] * elements.normals()[e][0];
    EXPECT_LT(abs(ones), 1e-35) << order;
    EXPECT_LT(abs(along), 1e-35) << order;
  }
}

TEST(second_routes, agree_with_the_first) {
  const auto expect = [](const char* kind, const char* cage, std::size_t places) {
    const std::vector<ResultRow> rows = second_route_rows(kind, cage);
    EXPECT_EQ(rows.size(), places) << kind << ' ' << cage;
    for (const ResultRow& row : rows)
      EXPECT_EQ(row.verdict, Verdict::Kept) << kind << ' ' << cage << ' ' << row.place << ' ' << row.max;
  };
  for (const char* cage : {"cube", "twisted-bar"}) {
    expect("spherical_mean_value", cage, 2);
    expect("maximum_entropy", cage, 1);
  }
  expect("positive_mean_value", "cube", 1);
  for (const char* kind : {"harmonic", "elastic", "biharmonic_boundary", "triharmonic_boundary"}) {
    expect(kind, "square", 2);
    expect(kind, "l-shape", 2);
    expect(kind, "star", 0);  // ten edges are too many
  }
  expect("spherical_mean_value", "icosphere", 0);  // 80 faces are too many
}

// Harmonic coordinates of a triangle are affine: layers represent them, and outside nothing is left but the route's own
// roundings.
TEST(second_routes, are_not_held_to_digits_of_nothing) {
  const Cage triangle = Cage::make_polygon("triangle", {{0, 0, 0}, {1, 0, 0}, {.3, .8, 0}},
                                           {{{0, 1, -1, -1}}, {{1, 2, -1, -1}}, {{2, 0, -1, -1}}}, {});
  const CoordinateKind& kind = coordinate_kind_named("harmonic");
  const CageCoordinates coordinates(triangle, kind, CoordinateOptions{});
  const auto route = second_routes::cage_route(kind, triangle);
  EXPECT_LT(second_route_error_at(coordinates, *route, {.86871, -.09582, 0}), 1e-30);
  EXPECT_LT(second_route_error_at(coordinates, *route, {.4, .3, 0}), 1e-30);
}

TEST(second_routes, are_of_recommended_evaluations) {
  CageCampaignOptions options;
  options.kinds = "biharmonic_boundary";
  options.evaluation = "offset-1e-6";
  options.points = 40;
  options.jobs = 1;
  for (const ResultRow& row : run_cage_campaign(embedded_cage("square"), options)) EXPECT_NE(row.check, "second_route");
}

// One coordinate in the twentieth digit, of the last block.
TEST(second_routes, see_a_first_route_that_is_off_by_less_than_double_shows) {
  for (const char* name : {"spherical_mean_value", "maximum_entropy", "harmonic", "elastic", "triharmonic_boundary"}) {
    const CoordinateKind& kind = coordinate_kind_named(name);
    const Cage cage = embedded_cage(kind.own_dimension == 3 ? "twisted-bar" : "l-shape");
    const Vec3<double> point(0.1, 0.2, kind.own_dimension == 3 ? 0.15 : 0);
    const CageCoordinates coordinates(cage, kind, CoordinateOptions{});
    const auto route = second_routes::cage_route(kind, cage);
    const std::string scalar(name_of(route->compared_in()));
    const auto bound = promise_for({"second_route", name, coordinates.evaluation(), scalar, cage.name(), 0}).bound;
    ASSERT_TRUE(bound) << name;
    EXPECT_LE(second_route_error_at(coordinates, *route, point), *bound) << name;
    second_routes::Blocks found;
    for (const Result<Mp100>& block : coordinates.at<Mp100>(convert<Mp100>(point), 0)) found.push_back(block.value);
    found.back().front() *= 1 + Mp100("1e-20");
    EXPECT_GT(route->error_at(point, found), *bound) << name;
  }
}

}  // namespace cageproof::validation::second_routes_test
