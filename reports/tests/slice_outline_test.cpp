// SPDX-License-Identifier: MIT
// The outline of a cage in a slice lies where the cage is cut, and nowhere else.
#include "slice_outline.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace cageproof::reports {
namespace {

using Segments = std::vector<std::array<Vec3<double>, 2>>;

// The cube from 0 to 1 with its corners in the order of bits x, y, z.
MeshField unit_cube(bool triangles) {
  MeshField cube{"cube", {}, {}, {}};
  for (int k = 0; k < 8; ++k) cube.vertices.emplace_back(k & 1, k >> 1 & 1, k >> 2 & 1);
  for (const auto& [a, b, c, d] : {std::array{0, 2, 3, 1}, std::array{4, 5, 7, 6}, std::array{0, 1, 5, 4},
                                   std::array{2, 6, 7, 3}, std::array{0, 4, 6, 2}, std::array{1, 3, 7, 5}}) {
    if (triangles) {
      cube.faces.push_back({a, b, c});
      cube.faces.push_back({a, c, d});
    } else {
      cube.faces.push_back({a, b, c, d});
    }
  }
  return cube;
}

// Expects segments that lie on the border of the unit square at that height, once around it.
void expect_unit_square(const Segments& outline, int axis, double height) {
  const int u = (axis + 1) % 3, v = (axis + 2) % 3;
  double length = 0;
  // The four sides one after another, each with what is covered of it.
  std::array<double, 4> covered{};
  for (const auto& [from, to] : outline) {
    // Where a corner lies in the slice there are segments of no length, which draw nothing.
    if (from == to) continue;
    length += (to - from).norm();
    for (const Vec3<double>& end : {from, to}) EXPECT_EQ(end[axis], height);
    int sides = 0;
    for (int side = 0; side < 4; ++side) {
      const int fixed = side < 2 ? u : v, along = side < 2 ? v : u;
      if (from[fixed] != side % 2 || to[fixed] != side % 2) continue;
      ++sides;
      covered[side] += std::abs(to[along] - from[along]);
      EXPECT_GE(std::min(from[along], to[along]), 0);
      EXPECT_LE(std::max(from[along], to[along]), 1);
    }
    EXPECT_EQ(sides, 1) << from.transpose() << " to " << to.transpose();
  }
  // A dyadic height and dyadic corners leave nothing to rounding.
  EXPECT_EQ(length, 4);
  for (const double side : covered) EXPECT_EQ(side, 1);
}

TEST(SliceOutline, OfTheUnitCubeIsTheUnitSquare) {
  for (const bool triangles : {true, false})
    for (int axis = 0; axis < 3; ++axis)
      for (const double height : {0.25, 0.5, 0.8125}) {
        SCOPED_TRACE(testing::Message() << (triangles ? "triangles" : "quads") << " across " << axis << " at "
                                        << height);
        expect_unit_square(outline_in_plane(unit_cube(triangles), axis, height), axis, height);
      }
}

TEST(SliceOutline, OfTheUnitCubeEndsAtItsCornersExactly) {
  const Segments outline = outline_in_plane(unit_cube(true), 2, 0.25);
  EXPECT_EQ(outline.size(), 8u);
  for (const double x : {0.0, 1.0})
    for (const double y : {0.0, 1.0}) {
      int ends = 0;
      for (const auto& segment : outline)
        ends += static_cast<int>(std::ranges::count(segment, Vec3<double>(x, y, 0.25)));
      EXPECT_EQ(ends, 2) << x << ' ' << y;
    }
}

TEST(SliceOutline, OfASliceBesideTheCageIsNothing) {
  for (const bool triangles : {true, false})
    for (int axis = 0; axis < 3; ++axis)
      for (const double height : {-0.125, 1.125})
        EXPECT_TRUE(outline_in_plane(unit_cube(triangles), axis, height).empty());
  EXPECT_TRUE(outline_in_plane({"none", {}, {}, {}}, 2, 0).empty());
}

// A slice draws an element that lies in it by its edges: a polygon's edges of two corners, and whole faces.
TEST(SliceOutline, OfWhatLiesInTheSliceIsItsEdges) {
  const MeshField edge{"edge", {{0, 0, 0}, {1, 2, 0}}, {{0, 1}}, {}};
  const Segments one = outline_in_plane(edge, 2, 0);
  ASSERT_EQ(one.size(), 1u);
  EXPECT_EQ(one[0][0], Vec3<double>(0, 0, 0));
  EXPECT_EQ(one[0][1], Vec3<double>(1, 2, 0));
  const MeshField face{"face", {{0, 0, 3}, {1, 0, 3}, {1, 1, 3}, {0, 1, 3}}, {{0, 1, 2, 3}}, {}};
  expect_unit_square(outline_in_plane(face, 2, 3), 2, 3);
}

// A saddle: its corners are at heights 0 and 1 in turn, so that on the bilinear quad the height is u + v - 2uv.
TEST(SliceOutline, OfAQuadIsThatOfItsBilinearSurface) {
  const MeshField quad{"quad", {{0, 0, 0}, {1, 0, 1}, {1, 1, 0}, {0, 1, 1}}, {{0, 1, 2, 3}}, {}};
  const Segments outline = outline_in_plane(quad, 2, 0.25);
  EXPECT_GT(outline.size(), 8u);
  for (const auto& segment : outline)
    for (const Vec3<double>& p : segment) EXPECT_NEAR(p[0] + p[1] - 2 * p[0] * p[1], 0.25, 0.01);
}

}  // namespace
}  // namespace cageproof::reports
