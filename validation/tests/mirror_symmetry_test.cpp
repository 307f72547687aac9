// SPDX-License-Identifier: MIT
// Cages that are their own mirror images: their vertices, and their elements.
#include "cages/mirror_symmetry.h"

#include "cageproof/core/cage/embedded_cages.h"

#include <gtest/gtest.h>

namespace cageproof::validation {
namespace {

TEST(mirror_symmetry, pairs_vertices_that_are_mirror_images) {
  const Cage cube = embedded_cage("cube");
  for (int axis = 0; axis < 3; ++axis) {
    const auto mirror = mirror_symmetry(cube.vertices(), axis);
    ASSERT_TRUE(mirror) << axis;
    for (std::size_t v = 0; v < cube.vertices().size(); ++v) {
      Vec3<double> image = cube.vertices()[v];
      image[axis] = -image[axis];
      EXPECT_EQ(cube.vertices()[mirror->vertex[v]], image);
      EXPECT_NE(mirror->vertex[v], static_cast<int>(v));
    }
  }
  // Away from the origin as well, up to rounding, and not for a vertex that is off by more.
  std::vector<Vec3<double>> moved;
  for (const auto& v : cube.vertices()) moved.emplace_back(v + Vec3<double>(1e3, 0.1, 0));
  EXPECT_TRUE(mirror_symmetry(moved, 0));
  moved[3][1] += 1e-9;
  EXPECT_FALSE(mirror_symmetry(moved, 0));
  EXPECT_FALSE(mirror_symmetry(embedded_cage("l-shape").vertices(), 0));
}

TEST(mirror_symmetry, is_of_quads_where_it_is_not_of_their_triangles) {
  const Cage cube = embedded_cage("cube");
  const CageElements quads(cube, true, Triangulation::Shortest), triangles(cube, false, Triangulation::Shortest);
  int broken = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const auto mirror = mirror_symmetry(cube.vertices(), axis).value();
    EXPECT_TRUE(keeps(mirror, quads)) << axis;
    broken += keeps(mirror, triangles) ? 0 : 1;
  }
  EXPECT_GT(broken, 0);
  const Cage square = embedded_cage("square");
  const CageElements segments(square, false, Triangulation::Shortest);
  for (int axis = 0; axis < 2; ++axis) EXPECT_TRUE(keeps(mirror_symmetry(square.vertices(), axis).value(), segments));
  // The same vertices, joined otherwise.
  const Cage crossed = Cage::make("crossed", cube.vertices(), cube.faces(), {});
  auto mirror = mirror_symmetry(crossed.vertices(), 0).value();
  std::swap(mirror.vertex[0], mirror.vertex[1]);
  EXPECT_FALSE(keeps(mirror, quads));
}

TEST(mirror_symmetry, is_what_positions_have_that_were_made_symmetric) {
  const Cage cube = embedded_cage("cube");
  std::vector<Vec3<double>> posed = cube.vertices();
  for (std::size_t v = 0; v < posed.size(); ++v) posed[v] += Vec3<double>(0.01, -0.02, 0.03) * static_cast<double>(v);
  const auto mirror = mirror_symmetry(cube.vertices(), 2).value();
  const auto found = made_symmetric(mirror, posed);
  for (std::size_t v = 0; v < posed.size(); ++v) {
    EXPECT_LT((found[mirror.vertex[v]] - mirror(found[v])).norm(), 1e-15);
    EXPECT_GT((found[v] - cube.vertices()[v]).norm(), 1e-3);
  }
}

}  // namespace
}  // namespace cageproof::validation
