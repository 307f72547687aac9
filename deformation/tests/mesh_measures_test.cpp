// SPDX-License-Identifier: MIT
// Measures of meshes under maps made by hand, whose numbers are known.
#include "support.h"

#include "cageproof/deformation/mesh_measures.h"

#include <gtest/gtest.h>

namespace cageproof::deformation {
namespace {

using test::Vec;

// A tetrahedron in the cube, closed; its fifth vertex has no face.
Mesh tetrahedron() {
  return {{{0, 0, 0}, {.25, 0, 0}, {0, .25, 0}, {0, 0, .25}, {.1, .1, .1}},
          {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}}};
}

std::vector<Vec> mapped(const Eigen::Matrix3d& linear, const Vec& shift, const std::vector<Vec>& points) {
  std::vector<Vec> images;
  images.reserve(points.size());
  for (const Vec& p : points) images.emplace_back(linear * p + shift);
  return images;
}

// The images of points under an affine map, with Jacobians.
PointImages affine_images(const Eigen::Matrix3d& linear, const Vec& shift, const std::vector<Vec>& points, int d) {
  PointImages found{std::vector<Images<double>>(1), std::vector<char>(points.size())};
  for (const Vec& image : mapped(linear, shift, points)) {
    found.maps[0].tensors[0].insert(found.maps[0].tensors[0].end(), image.data(), image.data() + d);
    for (int c = 0; c < d; ++c)
      for (int i = 0; i < d; ++i) found.maps[0].tensors[1].push_back(linear(c, i));
  }
  return found;
}

CageElements elements_of(const Cage& cage) { return {cage, false, Triangulation::Shortest}; }

TEST(MeshMeasures, of_an_affine_map_are_its_own) {
  const test::Case c = test::cube();
  const Mesh rest = tetrahedron();
  const Eigen::Matrix3d linear = Vec(2, -3, .5).asDiagonal();
  const Vec shift(1, 0, 0);
  const PointImages images = affine_images(linear, shift, rest.vertices, 3);
  const MeshMeasures found =
      measures_of(elements_of(c.cage), c.size, mapped(linear, shift, c.cage.vertices()), rest, images, 0, 1);
  EXPECT_EQ(found.missing, 0U);
  // The steps are (x + 1, -4 y, -z / 2).
  const double steps[]{1, 1.25, std::hypot(1, 1), std::hypot(1, .125), std::hypot(1.1, .4, .05)};
  EXPECT_NEAR(found.largest_displacement, std::sqrt(2), 1e-14);
  EXPECT_NEAR(found.mean_displacement, (steps[0] + steps[1] + steps[2] + steps[3] + steps[4]) / 5, 1e-14);
  EXPECT_NEAR(found.cage_ratio, -3, 1e-13);
  EXPECT_NEAR(found.mesh_ratio, -3, 1e-13);
  ASSERT_TRUE(found.jacobians);
  EXPECT_NEAR(found.jacobians->least_singular_value, .5, 1e-14);
  EXPECT_NEAR(found.jacobians->largest_singular_value, 3, 1e-14);
  EXPECT_EQ(found.jacobians->turned, 5U);
  EXPECT_EQ(found.jacobians->without, 0U);
  EXPECT_FALSE(measures_of(elements_of(c.cage), c.size, {}, rest, images, 0, 0).jacobians);
}

TEST(MeshMeasures, missing_points_and_points_on_the_cage_count_by_themselves) {
  const test::Case c = test::cube();
  const Mesh rest = tetrahedron();
  PointImages images = affine_images(2 * Eigen::Matrix3d::Identity(), Vec::Zero(), rest.vertices, 3);
  images.missing[3] = 1;
  images.maps[0].tensors[0][9] = 1e9;
  images.maps[0].tensors[1][27] = -1e9;
  images.maps[0].tensors[1][9] = NAN;
  const MeshMeasures found = measures_of(elements_of(c.cage), c.size, {}, rest, images, 0, 1);
  EXPECT_EQ(found.missing, 1U);
  EXPECT_NEAR(found.largest_displacement, .25, 1e-15);
  EXPECT_NEAR(found.mean_displacement, (.25 + .25 + .1 * std::sqrt(3)) / 4, 1e-15);
  EXPECT_EQ(found.jacobians->without, 1U);
  EXPECT_EQ(found.jacobians->turned, 0U);
  EXPECT_NEAR(found.jacobians->largest_singular_value, 2, 1e-14);
}

TEST(MeshMeasures, what_does_not_exist_is_nan) {
  const test::Case c = test::cube();
  Mesh open = tetrahedron();
  open.faces.pop_back();
  PointImages images = affine_images(Eigen::Matrix3d::Identity(), Vec::Zero(), open.vertices, 3);
  std::ranges::fill(images.missing, 1);
  const MeshMeasures found = measures_of(elements_of(c.cage), c.size, {}, open, images, 0, 1);
  EXPECT_TRUE(std::isnan(found.cage_ratio));
  EXPECT_TRUE(std::isnan(found.mesh_ratio));
  EXPECT_TRUE(std::isnan(found.mean_displacement));
  EXPECT_TRUE(std::isnan(found.largest_displacement));
}

// Roundings of a flat image lean to both sides.
TEST(MeshMeasures, what_is_pressed_flat_is_not_turned) {
  const test::Case c = test::cube();
  const Mesh rest = tetrahedron();
  Eigen::Matrix3d flat = Vec(1, 2, 0).asDiagonal();
  for (const double rounding : {0., 1e-16, -1e-16, -3e-15}) {
    flat(2, 2) = rounding;
    const PointImages images = affine_images(flat, Vec::Zero(), rest.vertices, 3);
    EXPECT_EQ(measures_of(elements_of(c.cage), c.size, {}, rest, images, 0, 1).jacobians->turned, 0U) << rounding;
  }
  flat(2, 2) = -1e-9;
  const PointImages images = affine_images(flat, Vec::Zero(), rest.vertices, 3);
  EXPECT_EQ(measures_of(elements_of(c.cage), c.size, {}, rest, images, 0, 1).jacobians->turned, 5U);
}

TEST(MeshMeasures, the_plane_has_areas) {
  const test::Case c = test::l_shape();
  Mesh rest{{{.1, .1, 0}, {.5, .1, 0}, {.4, .6, 0}}, {}};
  rest.segments = {{0, 1}, {1, 2}, {2, 0}};
  const Eigen::Matrix3d linear = Vec(2, .75, 1).asDiagonal();
  const PointImages images = affine_images(linear, {3, 1, 0}, rest.vertices, 2);
  const MeshMeasures found =
      measures_of(elements_of(c.cage), c.size, mapped(linear, {3, 1, 0}, c.cage.vertices()), rest, images, 0, 1);
  EXPECT_NEAR(found.cage_ratio, 1.5, 1e-14);
  EXPECT_NEAR(found.mesh_ratio, 1.5, 1e-14);
  EXPECT_NEAR(found.jacobians->least_singular_value, .75, 1e-14);
  EXPECT_NEAR(found.jacobians->largest_singular_value, 2, 1e-14);
}

}  // namespace
}  // namespace cageproof::deformation
