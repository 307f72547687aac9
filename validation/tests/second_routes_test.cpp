// SPDX-License-Identifier: MIT
// Second routes of kinds: known integrals, agreement with the first route, and a disagreement that is seen.
#include "cageproof/core/embedded_cages.h"
#include "cageproof/validation/cage_campaign.h"
#include "cageproof/validation/promise.h"
#include "cages/second_route_error.h"
#include "second_routes/spherical_route.h"

#include <gtest/gtest.h>

namespace cageproof::validation {
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

TEST(second_routes, agree_with_the_first) {
  for (const char* cage : {"cube", "twisted-bar"}) {
    const std::vector<ResultRow> rows = second_route_rows("spherical_mean_value", cage);
    EXPECT_EQ(rows.size(), 2) << cage;
    for (const ResultRow& row : rows) {
      EXPECT_EQ(row.verdict, Verdict::Kept) << cage << ' ' << row.place << ' ' << row.max;
      EXPECT_EQ(row.scalar, "mp100");
    }
  }
  EXPECT_TRUE(second_route_rows("spherical_mean_value", "icosphere").empty()) << "80 faces are too many";
}

// One coordinate in the twentieth digit.
TEST(second_routes, see_a_first_route_that_is_off_by_less_than_double_shows) {
  const Cage cage = embedded_cage("twisted-bar");
  for (const char* name : {"spherical_mean_value"}) {
    const CoordinateKind& kind = coordinate_kind_named(name);
    const CageCoordinates coordinates(cage, kind, CoordinateOptions{});
    const second_routes::CageRoute route = second_routes::cage_route(kind, cage);
    const auto bound = promise_for({"second_route", name, coordinates.evaluation(), "mp100", cage.name(), 0}).bound;
    ASSERT_TRUE(bound) << name;
    const Vec3<double> point(0.1, 0.2, 0.15);
    EXPECT_LE(second_route_error_at(coordinates, route, point), *bound) << name;
    const auto off = [&](const Vec3<double>& at) {
      std::vector<Mp100> found = route(at);
      found.front() *= 1 + Mp100("1e-20");
      return found;
    };
    EXPECT_GT(second_route_error_at(coordinates, off, point), *bound) << name;
  }
}

}  // namespace cageproof::validation
