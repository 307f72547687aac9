// SPDX-License-Identifier: MIT
// Elastic coordinates in space as `verify` asks them: promises, and a route that shares only the layers.
#include "cageproof/core/cage/embedded_cages.h"
#include "cageproof/core/coordinates/coordinates.h"
#include "cageproof/validation/cage_campaign.h"
#include "cageproof/validation/promise.h"
#include "cages/second_route_error.h"
#include "second_routes/cage_routes.h"

#include <gtest/gtest.h>

#include <map>

namespace cageproof::validation::elastic_in_space_test {
namespace {

TEST(elastic_in_space, keep_their_promises) {
  CageCampaignOptions options;
  options.kinds = "elastic";
  options.points = 40;
  options.truth_points = 2;
  options.on_points = 16;
  std::map<std::string, int> rows;
  for (const ResultRow& row : run_cage_campaign(embedded_cage("cube"), options)) {
    ++rows[row.check];
    EXPECT_NE(row.verdict, Verdict::Broken) << row.check << ' ' << row.place << ' ' << row.order << ": " << row.max;
  }
  for (const char* check : {"partition_of_unity", "linear_reproduction", "zero_outside", "cage_truth", "cage_scaling",
                            "cage_rigid_motion", "limit_from_inside", "second_route", "cage_differences"})
    EXPECT_GT(rows[check], 0) << check;
}

// One entry in the twentieth digit.
TEST(elastic_in_space, second_route_sees_what_double_does_not_show) {
  const CoordinateKind& kind = coordinate_kind_named("elastic");
  const Cage cage = embedded_cage("cube");
  const CageCoordinates coordinates(cage, kind, CoordinateOptions{});
  const auto route = second_routes::cage_route(kind, cage);
  ASSERT_NE(route, nullptr);
  EXPECT_EQ(second_routes::cage_route(kind, embedded_cage("icosphere")), nullptr);
  const Vec3<double> point(0.1, 0.2, 0.15);
  second_routes::Blocks found;
  for (const Result<Mp100>& block : coordinates.at<Mp100>(convert<Mp100>(point), 0)) found.push_back(block.value);
  EXPECT_LT(route->error_at(point, found), 1e-30);
  found.back().front() *= 1 + Mp100("1e-20");
  EXPECT_GT(route->error_at(point, found), 1e-30);
}

}  // namespace
}  // namespace cageproof::validation::elastic_in_space_test
