// SPDX-License-Identifier: MIT
// Solved coordinates depend only on the cage's shape, in every scalar, and so do their derivatives.
#include "support.h"

#include <gtest/gtest.h>

namespace cageproof::solved::test::invariance_test {
namespace {

class EverySolvedKind : public testing::TestWithParam<const char*> {};

INSTANTIATE_TEST_SUITE_P(kinds, EverySolvedKind, testing::Values("biharmonic_boundary", "harmonic", "cauchy"),
                         [](const auto& name) { return std::string(name.param); });

// Values of a cage that was scaled, without what its unit makes of them.
std::vector<double> without_unit(const CageCoordinates& coordinates, const Vec& point, double unit) {
  std::vector<double> all;
  const auto found = coordinates.at<double>(point, 0);
  for (std::size_t b = 0; b < found.size(); ++b)
    for (const double x : found[b].value) all.push_back(x / std::pow(unit, coordinates.blocks()[b].degree));
  return all;
}

TEST_P(EverySolvedKind, has_no_unit_of_length) {
  const Vec point(0.5, 0.75, 0);
  const auto expected = values_at(coordinates(polygon(l_shape), GetParam()), point);
  for (const double unit : {1e-150, 1e-6, 0.7, 3., 1e6, 1e150}) {
    const CageCoordinates other = coordinates(polygon(l_shape, unit), GetParam());
    EXPECT_LT(largest_difference(without_unit(other, unit * point, unit), expected), 1e-13) << unit;
  }
}

TEST_P(EverySolvedKind, has_no_origin) {
  const Vec point(0.5, 0.75, 0), offset(1e6, -3e6, 0);
  const auto expected = values_at(coordinates(polygon(l_shape), GetParam()), point);
  const CageCoordinates other = coordinates(polygon(l_shape, 1, offset), GetParam());
  EXPECT_LT(largest_difference(values_at(other, point + offset), expected), 1e-13);
}

TEST_P(EverySolvedKind, turns_with_the_cage) {
  const double c = std::cos(0.6), s = std::sin(0.6);
  Corners turned;
  for (const auto& [x, y] : l_shape) turned.push_back({c * x - s * y, s * x + c * y});
  const Vec point(0.5, 0.75, 0), there(c * point[0] - s * point[1], s * point[0] + c * point[1], 0);
  EXPECT_LT(largest_difference(values_at(coordinates(polygon(turned), GetParam()), there),
                               values_at(coordinates(polygon(l_shape), GetParam()), point)),
            1e-13);
}

// The vertex that the frame begins at is one as any other.
TEST_P(EverySolvedKind, begins_anywhere) {
  Corners rotated = l_shape;
  std::rotate(rotated.begin(), rotated.begin() + 1, rotated.end());
  const Vec point(0.5, 0.75, 0);
  const CageCoordinates a = coordinates(polygon(l_shape), GetParam()), b = coordinates(polygon(rotated), GetParam());
  const auto first = a.at<double>(point, 0), second = b.at<double>(point, 0);
  for (std::size_t block = 0; block < first.size(); ++block)
    for (std::size_t i = 0; i < 6; ++i) EXPECT_NEAR(first[block].value[(i + 1) % 6], second[block].value[i], 1e-13);
}

TEST_P(EverySolvedKind, has_its_digits_in_every_scalar) {
  const CageCoordinates c = coordinates(polygon(convex_pentagon), GetParam());
  for (const Vec& point : {Vec(0.75, 0.5, 0), Vec(1, 0, 0), Vec(0, 0, 0)}) {
    const auto wide = c.at<Mp100>(convert<Mp100>(point), 0), fifty_block = std::vector<Result<Mp100>>();
    const auto fifty = c.at<Mp50>(convert<Mp50>(point), 0);
    const auto twice = c.at<double>(point, 0);
    const auto single = c.at<float>(convert<float>(point), 0);
    for (std::size_t b = 0; b < wide.size(); ++b)
      for (std::size_t i = 0; i < wide[b].value.size(); ++i) {
        const Mp100& truth = wide[b].value[i];
        EXPECT_LT(static_cast<double>(Mp100(abs(Mp100(fifty[b].value[i]) - truth))), 1e-45);
        EXPECT_LT(static_cast<double>(Mp100(abs(Mp100(twice[b].value[i]) - truth))), 1e-12);
        EXPECT_LT(static_cast<double>(Mp100(abs(Mp100(single[b].value[i]) - truth))), 1e-6);
      }
  }
  EXPECT_TRUE(c.is_exact_in(ScalarKind::Digits50) && c.is_exact_in(ScalarKind::Digits100));
}

TEST_P(EverySolvedKind, has_the_derivatives_of_its_values) {
  const CageCoordinates c = coordinates(polygon(l_shape, 3), GetParam());
  const Mp100 step("1e-30");
  const Vec3<Mp100> point(Mp100("1.4"), Mp100("2.2"), Mp100(0));
  const auto found = c.at<Mp100>(point, 2);
  for (int a = 0; a < 2; ++a) {
    Vec3<Mp100> plus = point, minus = point;
    plus[a] += step;
    minus[a] -= step;
    const auto up = c.at<Mp100>(plus, 1), down = c.at<Mp100>(minus, 1);
    for (std::size_t b = 0; b < found.size(); ++b)
      for (int o = 1; o <= 2; ++o)
        for (std::size_t i = 0; i < up[b].of(o - 1).size(); ++i) {
          const Mp100 difference = (up[b].of(o - 1)[i] - down[b].of(o - 1)[i]) / (2 * step);
          EXPECT_LT(static_cast<double>(Mp100(abs(difference - found[b].of(o)[2 * i + a]))), 1e-50);
        }
  }
}

// Points on the cage that are doubles, next to one inside: values differ by the distance times gradients, with a
// logarithm of it.
TEST_P(EverySolvedKind, is_continuous_up_to_the_cage) {
  const CageCoordinates c = coordinates(polygon(l_shape), GetParam());
  const double step = 1e-12;
  const std::vector<std::pair<Vec, Vec>> places{{{0.5, 0, 0}, {0, 1, 0}},      {{0.3125, 0, 0}, {0, 1, 0}},
                                                {{0, 0, 0}, {1, 0.5, 0}},      {{1, 1, 0}, {-1, -0.25, 0}},
                                                {{1, 1.625, 0}, {-1, 0.1, 0}}, {{2, 1, 0}, {-0.5, -1, 0}}};
  for (const auto& [point, inward] : places)
    EXPECT_LT(largest_difference(values_at(c, point), values_at(c, point + step * inward)), 1e-9) << point.transpose();
}

TEST_P(EverySolvedKind, has_derivatives_from_inside_within_edges) {
  const CageCoordinates c = coordinates(polygon(l_shape), GetParam());
  const Vec point(0.3125, 0, 0), near(0.3125, 1e-9, 0);
  const auto on = c.at<double>(point, 2), inside = c.at<double>(near, 2);
  for (std::size_t b = 0; b < on.size(); ++b)
    for (int o = 1; o <= 2; ++o) EXPECT_LT(largest_difference(on[b].of(o), inside[b].of(o)), 1e-5) << b << ' ' << o;
}

TEST_P(EverySolvedKind, is_the_same_for_many_points_at_once) {
  const CageCoordinates c = coordinates(polygon(l_shape), GetParam());
  std::vector<Vec> points;
  points.reserve(70);
  for (int i = 0; i < 70; ++i) points.emplace_back(0.015625 * i, 0.5, 0);  // the first on the cage
  const auto together = c.at<double>(std::span<const Vec>(points), 2);
  for (std::size_t p = 0; p < points.size(); ++p) {
    const auto alone = c.at<double>(points[p], 2);
    for (std::size_t b = 0; b < alone.size(); ++b)
      for (int o = 0; o <= (p == 0 ? 0 : 2); ++o)
        for (std::size_t i = 0; i < alone[b].of(o).size(); ++i)
          EXPECT_EQ(together[b].tensors[o][p * together[b].stride[o] + i], alone[b].of(o)[i]);
  }
}

}  // namespace
}  // namespace cageproof::solved::test::invariance_test
