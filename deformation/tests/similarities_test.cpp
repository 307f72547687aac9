// SPDX-License-Identifier: MIT
// The similarity next to a pose: the cage itself where that is the pose, and to rounding where that is a similarity.
#include "layers/similarities.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

namespace cageproof::deformation::test {
namespace {

using Rows = Matrix<double>;

const Rows& ball() {
  static const Rows rows{{0, 0, 0}, {1, .25, 0}, {.5, 1, .125}, {.25, .5, 1}, {-.5, .75, -.25}};
  return rows;
}

Rows rod(double thin) {
  Rows rows = ball();
  rows.rightCols(2) *= thin;
  // Along no axis, where coordinates would be as fine as the rod is thin.
  return rows * Eigen::AngleAxisd(.8, Eigen::Vector3d(1, 2, 3).normalized()).toRotationMatrix();
}

TEST(similarities, next_to_shifts_turn_nothing) {
  const Rows normals = Rows::Identity(3, 3);
  for (const Rows& rest : {ball(), rod(1e-8)}) {
    const Similar<double> same = Similarities<double>(rest, normals).next_to(rest);
    EXPECT_EQ(same.vertices, rest);
    EXPECT_EQ(same.normals, normals);
  }
  const Rows moved = ball().rowwise() + Eigen::RowVector3d(2, -.5, 4);
  const Similar<double> shifted = Similarities<double>(ball(), normals).next_to(moved);
  EXPECT_LT((shifted.vertices - moved).cwiseAbs().maxCoeff(), 1e-15);
  EXPECT_EQ(shifted.normals, normals);
}

// Vertices to rounding, and the turn about a rod as well as its vertices say.
TEST(similarities, next_to_turned_and_scaled_cages_are_those) {
  const Rows turn = 1.75 * Eigen::AngleAxisd(2.1, Eigen::Vector3d(-1, .2, .3).normalized()).toRotationMatrix();
  const Rows normals = Rows::Identity(3, 3);
  for (const double thin : {1., 1e-4, 1e-7}) {
    const Rows rest = rod(thin), posed = (rest * turn.transpose()).rowwise() + Eigen::RowVector3d(1, 2, 3);
    const Similar<double> found = Similarities<double>(rest, normals).next_to(posed);
    EXPECT_LT((found.vertices - posed).cwiseAbs().maxCoeff(), 4e-15) << thin;
    EXPECT_LT((found.normals - turn.transpose()).cwiseAbs().maxCoeff(), 1e-14 / thin) << thin;
    const Similarities<Mp50> wide(rest.cast<Mp50>(), normals.cast<Mp50>());
    EXPECT_LT(static_cast<double>(Mp50((wide.next_to(posed.cast<Mp50>()).vertices - posed.cast<Mp50>()).norm())), 1e-14)
        << thin;
  }
}

TEST(similarities, turn_polygons_and_mirror_nothing) {
  const Rows rest{{0, 0}, {2, 0}, {1, 1}}, normals = Rows::Identity(2, 2);
  const Rows quarter{{0, -1}, {1, 0}}, mirror{{-1, 0}, {0, 1}};
  const Similarities<double> of_triangle(rest, normals);
  EXPECT_LT((of_triangle.next_to(rest * quarter.transpose()).normals - quarter.transpose()).norm(), 1e-15);
  EXPECT_GT(of_triangle.next_to(rest * mirror.transpose()).normals.determinant(), 0);
}

// All vertices at one place, or so far off that sums leave the range of double.
TEST(similarities, shrink_to_a_place_where_there_is_no_other) {
  const Rows normals = Rows::Identity(3, 3), here = Rows::Constant(5, 3, 2);
  const Similar<double> point = Similarities<double>(ball(), normals).next_to(here);
  EXPECT_LT((point.vertices - here).norm(), 1e-14);
  EXPECT_LT(point.normals.norm(), 1e-14);
  EXPECT_TRUE(Similarities<double>(ball(), normals).next_to(1e300 * ball()).vertices.allFinite());
}

}  // namespace
}  // namespace cageproof::deformation::test
