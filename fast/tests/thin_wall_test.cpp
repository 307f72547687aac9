// SPDX-License-Identifier: MIT
// Next to one side of a thin wall, and on it: what the sides sum to is small against what each side gives.
#include "block_errors.h"

#include <gtest/gtest.h>

namespace cageproof {
namespace {

using namespace block_errors;

// Two square pyramids on each other, that high. All vertices but two are on the rim, where both sides meet.
Cage flat_octahedron(double height) {
  std::vector<Face> faces;
  for (const std::array<int, 4>& f : {std::array{0, 2, 4, -1},
                                      {2, 1, 4, -1},
                                      {1, 3, 4, -1},
                                      {3, 0, 4, -1},
                                      {2, 0, 5, -1},
                                      {1, 2, 5, -1},
                                      {3, 1, 5, -1},
                                      {0, 3, 5, -1}})
    faces.push_back({f});
  return Cage::make("flat octahedron", {{1, 0, 0}, {-1, 0, 0}, {0, height, 0}, {0, -height, 0}, {0, 0, 1}, {0, 0, -1}},
                    faces, {});
}

// Exactly on vertices, edges and a face: on the rim and off it.
std::vector<Point> points_on_octahedron(double height) {
  return {{1, 0, 0},
          {0, 0, -1},
          {0, height, 0},
          {0.5, 0, 0.5},
          {-0.5, height / 2, 0},
          {.75, 0, .25},
          {0, -height / 2, 0.5},
          {0.25, height / 2, 0.25},
          {-.5, -height / 4, .25}};
}

class ThinWall : public testing::TestWithParam<double> {};

TEST_P(ThinWall, points_on_it) {
  const Cage cage = flat_octahedron(GetParam());
  for (const char* kind : {"green", "biharmonic", "somigliana"}) {
    const CageCoordinates found = coordinates_of(cage, kind, "batched"), reference = coordinates_of(cage, kind, "");
    for (const Point& p : points_on_octahedron(GetParam())) {
      ASSERT_FALSE(found.elements().touching(p).empty()) << p.transpose();
      const Vec3<Mp50> inside = convert<Mp50>(p) * (1 - Mp50("1e-11"));
      for (const int order : {0, 1, 2})
        EXPECT_LE(block_error_on(found, reference, cage.size(), p, inside, order), 64)
            << kind << ", order " << order << " at " << p.transpose();
    }
  }
}

// In all directions, of which some leave the wall.
TEST_P(ThinWall, points_a_rounding_off_it) {
  const Cage cage = flat_octahedron(GetParam());
  for (const char* kind : {"green", "biharmonic", "somigliana"}) {
    const CageCoordinates found = coordinates_of(cage, kind, "batched"), reference = coordinates_of(cage, kind, "");
    for (const Point& p : points_on_octahedron(GetParam()))
      for (const Point& towards : {Point(-1, 0, 1), Point(1, 1, 1), Point(1, -1, -1)}) {
        const Point beside = p + 0x1p-52 * towards;
        if (!found.elements().touching(beside).empty()) continue;
        for (const int order : {0, 1, 2})
          EXPECT_LE(block_error(found, reference, cage.size(), beside, order, OfHessians::WithSlope), 64)
              << kind << ", order " << order << ", off " << p.transpose() << " by " << (beside - p).transpose();
      }
  }
}

INSTANTIATE_TEST_SUITE_P(of_a_height, ThinWall, testing::Values(1e-2, 1e-4, 1e-6));

}  // namespace
}  // namespace cageproof
