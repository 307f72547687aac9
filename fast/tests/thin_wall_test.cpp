// SPDX-License-Identifier: MIT
// Next to one side of a thin wall, and on it: what the sides sum to is small against what each side gives.
#include "block_errors.h"

#include <gtest/gtest.h>

namespace cageproof {
namespace {

using namespace block_errors;

// Two pyramids on each other, about that high, no mirror images. All vertices but two are on the rim, where both sides
// meet.
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
  return Cage::make(
      "flat octahedron",
      {{1, 0, 0}, {-1, 0, 0.125}, {0.125, height, 0.0625}, {0, -0.75 * height, 0}, {0, 0, 1}, {-0.25, 0, -1}}, faces,
      {});
}

Cage flat_quadrangle(double height) {
  return Cage::make_polygon("flat quadrangle", {{1, 0, 0}, {0.125, height, 0}, {-1, 0, 0}, {0, -0.75 * height, 0}},
                            {{{0, 1, -1, -1}}, {{1, 2, -1, -1}}, {{2, 3, -1, -1}}, {{3, 0, -1, -1}}});
}

// All vertices, points on all edges and, of triangles, within them, exactly.
std::vector<Point> points_on(const Cage& cage, const CageElements& elements) {
  std::vector<Point> points = cage.vertices();
  for (std::size_t f = 0; f < elements.count(); ++f) {
    const auto k = elements.corners(f);
    const auto vertices = elements.vertices_of(f);
    for (std::size_t i = 0; i < k.size(); ++i) {
      const std::size_t j = (i + 1) % k.size();
      if (vertices[i] < vertices[j]) points.emplace_back(0.5 * (k[i] + k[j]));
    }
    if (k.size() > 2) points.emplace_back(0.25 * k[0] + 0.5 * k[1] + 0.25 * k[2]);
  }
  return points;
}

void expect_small_errors_on(const Cage& cage) {
  for (const char* kind : {"green", "biharmonic", "somigliana"}) {
    const CageCoordinates found = coordinates_of(cage, kind, "batched"), reference = coordinates_of(cage, kind, "");
    for (const Point& p : points_on(cage, found.elements())) {
      if (found.elements().touching(p).empty()) continue;  // rounding has moved it
      const Vec3<Mp50> inside = convert<Mp50>(p) * (1 - Mp50("1e-11"));
      for (const int order : {0, 1, 2})
        EXPECT_LE(block_error_on(found, reference, cage.size(), p, inside, order), 64)
            << cage.name() << ", " << kind << ", order " << order << " at " << p.transpose();
    }
  }
}

class ThinWall : public testing::TestWithParam<double> {};

TEST_P(ThinWall, points_on_it) {
  expect_small_errors_on(flat_octahedron(GetParam()));
  expect_small_errors_on(flat_quadrangle(GetParam()));
}

// In all directions, of which some leave the wall.
TEST_P(ThinWall, points_a_rounding_off_it) {
  const Cage cage = flat_octahedron(GetParam());
  for (const char* kind : {"green", "biharmonic", "somigliana"}) {
    const CageCoordinates found = coordinates_of(cage, kind, "batched"), reference = coordinates_of(cage, kind, "");
    int turn = 0;
    for (const Point& p : points_on(cage, found.elements()))
      for (const Point& towards : {Point(-1, 0, 1), Point(1, 1, 1), Point(1, -1, -1)}) {
        const Point beside = p + 0x1p-52 * towards;
        if (!found.elements().touching(beside).empty()) continue;
        const int order = turn++ % 3;
        EXPECT_LE(block_error(found, reference, cage.size(), beside, order, OfHessians::WithSlope), 64)
            << kind << ", order " << order << ", off " << p.transpose() << " by " << (beside - p).transpose();
      }
    EXPECT_GE(turn, 40);
  }
}

// Kinds that keep quads are the same where there are none.
TEST_P(ThinWall, kinds_that_keep_quads) {
  const Cage cage = flat_octahedron(GetParam());
  const CageCoordinates quads = coordinates_of(cage, "quad_mean_value", "batched"),
                        triangles = coordinates_of(cage, "mean_value", "batched");
  for (const Point& p : {Point(0.283, 0.02 * GetParam(), 0.7171), Point(0.1, 0.2 * GetParam(), 0.3), Point(1, 1, -1)}) {
    const auto a = quads.at<double>(p, 2), b = triangles.at<double>(p, 2);
    for (int o = 0; o <= 2; ++o) EXPECT_EQ(a[0].of(o), b[0].of(o)) << p.transpose();
  }
}

INSTANTIATE_TEST_SUITE_P(of_a_height, ThinWall, testing::Values(1e-2, 1e-4, 1e-6));

}  // namespace
}  // namespace cageproof
