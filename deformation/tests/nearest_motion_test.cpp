// SPDX-License-Identifier: MIT
// The rigid motion next to constraints: the one that they are made by, and the least where they leave turns free.
#include "nearest_motion.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

namespace cageproof::deformation::test::nearest_motion_test {
namespace {

using Vec = Vec3<double>;
using Mat = Mat3<double>;

Motion<double> motion_of(const std::vector<Vec>& at, const std::vector<Vec>& to, int dimension,
                         const std::vector<Constraints::Orientation>& orientations = {}) {
  Constraints constraints{.orientations = orientations};
  for (std::size_t p = 0; p < at.size(); ++p) constraints.positions.push_back({at[p], to[p]});
  return nearest_motion<double>(constraints, to, {.25, -.5, 0}, 2, dimension);
}

Vec image(const Motion<double>& motion, const Vec& at) {
  return in_three<double>(motion.turn) * (at - motion.from) + motion.to;
}

std::vector<Vec> moved(const std::vector<Vec>& points, const Mat& turn, const Vec& shift) {
  std::vector<Vec> found;
  found.reserve(points.size());
  for (const Vec& p : points) found.emplace_back(turn * p + shift);
  return found;
}

TEST(nearest_motion, is_the_one_that_targets_come_from) {
  const Mat flat = Eigen::AngleAxisd(2.5, Vec::UnitZ()).toRotationMatrix(),
            turn = Eigen::AngleAxisd(1.9, Vec(1, 2, -.5).normalized()).toRotationMatrix();
  const std::vector<Vec> in_plane{{0, 0, 0}, {1, .25, 0}}, in_space{{0, 0, 0}, {1, 0, 0}, {.5, 2, 0}};
  for (const double far : {0., 1e3}) {
    const Vec shift(3 + far, -2, 0);
    const Motion<double> plane = motion_of(in_plane, moved(in_plane, flat, shift), 2),
                         space = motion_of(in_space, moved(in_space, turn, shift), 3);
    for (const Vec& p : {Vec(1, 2, 0), Vec(-3, 1, 0)}) {
      EXPECT_LT((image(plane, p) - (flat * p + shift)).norm(), 2e-15 * (1 + far));
      EXPECT_LT((image(space, p) - (turn * p + shift)).norm(), 2e-15 * (1 + far));
    }
  }
}

// Next to a line, as positions along a spine are: a turn about it is found as well as doubles say how far off they are.
TEST(nearest_motion, turns_about_the_line_that_points_are_next_to) {
  for (const double off : {0x1p-10, 0x1p-18, 0x1p-33}) {
    const std::vector<Vec> at{{.5, .5, .25}, {.5, .5, .75}, {.5 + off, .5, .5}},
        to{{-.5, .5, .25}, {-.5, .5, .75}, {-.5, .5 + off, .5}};
    const Motion<double> quarter = motion_of(at, to, 3);
    EXPECT_LT((image(quarter, {.25, .5, .5}) - Vec(-.5, .25, .5)).norm(), 1e-15) << off;
  }
}

// One position leaves all turns free, a line in space those about it.
TEST(nearest_motion, turns_no_more_than_it_must) {
  const Motion<double> one = motion_of({{1, 2, 3}}, {{4, 2, 3}}, 3);
  EXPECT_EQ(Mat(one.turn), Mat::Identity());
  EXPECT_LT((image(one, {0, 0, 0}) - Vec(3, 0, 0)).norm(), 1e-15);
  const std::vector<Vec> line{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}};
  const Motion<double> quarter = motion_of(line, {{0, 0, 0}, {0, 1, 0}, {0, 2, 0}}, 3),
                       back = motion_of(line, {{2, 0, 0}, {1, 0, 0}, {0, 0, 0}}, 3);
  EXPECT_LT((image(quarter, {0, 0, 1}) - Vec(0, 0, 1)).norm(), 1e-15) << "twisted";
  EXPECT_LT((image(quarter, {0, 1, 0}) - Vec(-1, 0, 0)).norm(), 1e-15);
  EXPECT_LT((image(back, {2, 0, 0})).norm(), 1e-15);
  EXPECT_NEAR(Mat(back.turn).determinant(), 1, 4e-15);
}

TEST(nearest_motion, mirrors_nothing) {
  const std::vector<Vec> plane{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, space{{0, 0, 0}, {1, 0, 0}, {0, 2, 0}, {0, 0, 3}};
  const Mat mirror = Vec(1, -1, 1).asDiagonal();
  EXPECT_NEAR(in_three<double>(motion_of(plane, moved(plane, mirror, {1, 0, 0}), 2).turn).determinant(), 1, 4e-15);
  EXPECT_NEAR(Mat(motion_of(space, moved(space, mirror, {1, 0, 0}), 3).turn).determinant(), 1, 4e-15);
}

TEST(nearest_motion, follows_orientations) {
  const Mat turn = Eigen::AngleAxisd(.7, Vec(1, 1, 1).normalized()).toRotationMatrix();
  EXPECT_LT((Mat(motion_of({}, {}, 3, {{{0, 0, 0}, turn}}).turn) - turn).norm(), 2e-15);
  EXPECT_LT((Mat(motion_of({{1, 2, 3}}, {{0, 0, 0}}, 3, {{{0, 0, 0}, turn}}).turn) - turn).norm(), 2e-15);
}

}  // namespace
}  // namespace cageproof::deformation::test::nearest_motion_test
