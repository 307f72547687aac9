// SPDX-License-Identifier: MIT
// Plain closed forms against values that are known, and against what only a plain form does.
#include "cageproof/core/catalogue/evaluation.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace cageproof::closed_form::plain_test {
namespace {

template <Scalar R>
R value_of(std::string_view formula, std::string_view evaluation, const std::vector<Vec3<R>>& corners,
           const Vec3<R>& point, std::size_t entry = 0) {
  Result<R> result;
  evaluation_named(formula, evaluation)(Query<R>{corners, point}, result);
  return result.of(0)[entry];
}

// An octant's face, whose solid angle from the origin is an eighth of the sphere.
template <Scalar R>
const std::vector<Vec3<R>> octant{Vec3<R>(1, 0, 0), Vec3<R>(0, 1, 0), Vec3<R>(0, 0, 1)};

TEST(plain, sees_an_eighth_of_the_sphere) {
  EXPECT_NEAR(value_of<double>("triangle.solid_angle", "plain", octant<double>, {0, 0, 0}), std::numbers::pi / 2,
              4e-16);
  EXPECT_NEAR(value_of<float>("triangle.solid_angle", "plain", octant<float>, {0, 0, 0}), std::numbers::pi_v<float> / 2,
              4e-7F);
}

// Seen from the origin the octant's edges are quarter circles, so that Eq 14 is pi/4 for each corner.
TEST(plain, and_the_printed_form_have_the_octants_mean_value_weights) {
  for (const std::string_view name : {"plain", "published"})
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_NEAR(value_of<double>("triangle.mean_value", name, octant<double>, {0, 0, 0}, k), std::numbers::pi / 4,
                  1e-15)
          << name;
      EXPECT_NEAR(value_of<float>("triangle.mean_value", name, octant<float>, {0, 0, 0}, k),
                  std::numbers::pi_v<float> / 4, 1e-6F)
          << name;
    }
}

// int ln r over the unit segment seen from a point one unit above its first end is (ln 2)/2 - 1 + pi/4.
TEST(plain, integrates_the_logarithm_over_the_unit_segment) {
  const double expected = -(std::numbers::ln2 / 2 - 1 + std::numbers::pi / 4) / (2 * std::numbers::pi);
  EXPECT_NEAR(value_of<double>("segment.single_layer", "plain", {{0, 0, 0}, {1, 0, 0}}, {0, 1, 0}), expected, 1e-16);
  EXPECT_NEAR(value_of<float>("segment.single_layer", "plain", {{0, 0, 0}, {1, 0, 0}}, {0, 1, 0}),
              static_cast<float>(expected), 1e-7F);
}

// Far away the edge form cancels: what float's has left five hundred sizes away shows that nothing wider ran.
TEST(plain, loses_far_away_what_its_scalar_has_not) {
  const std::vector<Vec3<float>> corners{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  const Vec3<float> point(300, 200, -350);
  std::vector<Vec3<Mp50>> wide;
  wide.reserve(corners.size());
  for (const Vec3<float>& corner : corners) wide.push_back(convert<Mp50>(corner));
  const auto truth =
      static_cast<double>(value_of<Mp50>("triangle.double_layer", "closed_form", wide, convert<Mp50>(point)));
  const auto error = [&](std::string_view evaluation) {
    return std::abs(value_of<float>("triangle.double_layer", evaluation, corners, point) / truth - 1);
  };
  EXPECT_GT(error("plain"), 1e-5);
  EXPECT_LT(error("closed_form"), 1e-7);
}

TEST(plain, is_zero_beside_the_triangle_in_its_plane_and_infinite_on_it) {
  const std::vector<Vec3<double>> corners{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  for (const std::string_view name : {"plain", "published"}) {
    EXPECT_EQ(value_of<double>("triangle.mean_value", name, corners, {2, 2, 0}), 0) << name;
    EXPECT_EQ(value_of<double>("triangle.mean_value", name, corners, {0.25, 0.25, 0}),
              std::numeric_limits<double>::infinity())
        << name;
  }
}

}  // namespace
}  // namespace cageproof::closed_form::plain_test
