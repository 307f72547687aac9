// SPDX-License-Identifier: MIT
// Points around a cage, some radii away: faces are near for their size, and what they add up to is smaller than each.
#include "block_errors.h"
#include "thinned.h"

#include "cageproof/core/cage/embedded_cages.h"
#include "cageproof/core/geometry/box.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <tuple>

namespace cageproof {
namespace {

using namespace block_errors;

// From the box's centre, from one radius of the cage on.
std::vector<Point> around(const Cage& cage, int count) {
  const auto [low, high] = box_of(cage.vertices());
  const Point centre = (low + high) / 2;
  double radius = 0;
  for (const Point& v : cage.vertices()) radius = std::max(radius, (v - centre).norm());
  std::vector<Point> points;
  points.reserve(count);
  for (int i = 0; i < count; ++i) {
    RandomStream random(19, "around/" + cage.name(), i);
    const double distance = radius * std::pow(10., 1.1 * i / count);
    points.emplace_back(centre + distance * direction(random));
  }
  return points;
}

class Around : public testing::TestWithParam<std::tuple<const char*, const char*>> {};

TEST_P(Around, keep_the_promise_some_radii_away) {
  const auto [kind, name] = GetParam();
  const Cage cage = embedded_cage(name);
  const CageCoordinates found = coordinates_of(cage, kind, "batched"), reference = coordinates_of(cage, kind, "");
  ASSERT_EQ(found.evaluation(), "batched");
  // Each order is computed in its own way.
  for (const Point& p : thinned(around(cage, 40))) {
    const auto truth = block_truth(reference, p, 2, OfHessians::WithSlope);
    for (const int order : {0, 1, 2})
      EXPECT_LE(block_error(found, truth, cage.size(), p, order), 64) << "order " << order << " at " << p.transpose();
  }
}

INSTANTIATE_TEST_SUITE_P(of_kinds, Around,
                         testing::Combine(testing::Values("green", "biharmonic", "somigliana"),
                                          testing::Values("icosphere", "cube", "twisted-bar", "spiky-box", "thin-box",
                                                          "needles-1e-2", "bevel-1e-5")));

}  // namespace
}  // namespace cageproof
