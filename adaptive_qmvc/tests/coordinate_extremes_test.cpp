// SPDX-License-Identifier: MIT
// Coordinates of points so close to a cage that weights, or squares of distances, leave doubles' range, and in cages at
// its ends: they are one in sum and reproduce the point.
#include "cageproof/core/coordinates/coordinates.h"

#include <gtest/gtest.h>

#include <cmath>

namespace cageproof::adaptive_qmvc {
namespace {

using Vec = Vec3<double>;

// The unit cube times 2^exponent, of quads, or of triangles cut along one diagonal each.
Cage cube(bool of_triangles, int exponent = 0) {
  std::vector<Vec> vertices;
  vertices.reserve(8);
  for (int v = 0; v < 8; ++v) vertices.emplace_back(std::ldexp(1., exponent) * Vec(v & 1, v >> 1 & 1, v >> 2));
  std::vector<Face> faces;
  faces.reserve(12);
  for (const std::array<int, 4>& f :
       {std::array{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {1, 3, 7, 5}, {3, 2, 6, 7}, {2, 0, 4, 6}}) {
    if (of_triangles) {
      faces.push_back(Face{{f[0], f[1], f[2], -1}});
      faces.push_back(Face{{f[0], f[2], f[3], -1}});
    } else {
      faces.push_back(Face{f});
    }
  }
  return Cage::make("cube", std::move(vertices), std::move(faces));
}

// Beside a face, a face's diagonal, an edge, a vertex; d away, on either side.
std::vector<Vec> points_at(double d) {
  return {Vec(.25, .375, d),  Vec(.25, .25, d), Vec(.25, d, d),  Vec(d, d, d),   Vec(d, .5, .5),
          Vec(.5, d, 0),      Vec(0, 0, d),     Vec(1, 1, d),    Vec(-d, d, .5), Vec(-d, d, d),
          Vec(.25, .375, -d), Vec(.25, -d, -d), Vec(-d, -d, -d), Vec(-d, .5, .5)};
}

class Extremes : public testing::TestWithParam<const char*> {};

TEST_P(Extremes, reproduce_points_next_to_the_cage) {
  for (const bool of_triangles : {false, true}) {
    const Cage cage = cube(of_triangles);
    const CageCoordinates coordinates(cage, *find_coordinate_kind(GetParam()), CoordinateOptions{});
    for (const double d : {5e-324, 1e-310, 1e-162})
      for (const Vec& point : points_at(d)) {
        const std::vector<double> lambda = coordinates.at<double>(point, 0)[0].value;
        double sum = -1;
        Vec missing = -point;
        for (std::size_t v = 0; v < lambda.size(); ++v) {
          sum += lambda[v];
          missing += lambda[v] * cage.vertices()[v];
        }
        EXPECT_LT(std::abs(sum), 1e-14) << point.transpose();
        EXPECT_LT(missing.norm(), 1e-14) << point.transpose();
      }
  }
}

TEST_P(Extremes, do_not_depend_on_the_unit) {
  const Vec point(.25, .375, .125);
  const auto values = [&](int exponent, const Vec& at) {
    return CageCoordinates(cube(false, exponent), *find_coordinate_kind(GetParam()), CoordinateOptions{})
        .at<double>(at, 0)[0]
        .value;
  };
  const std::vector<double> plain = values(0, point);
  for (const int exponent : {-1060, -600, -330, -265, 265, 600, 1020}) {
    const std::vector<double> found = values(exponent, std::ldexp(1., exponent) * point);
    for (std::size_t v = 0; v < plain.size(); ++v) EXPECT_NEAR(found[v], plain[v], 1e-14) << exponent;
  }
}

INSTANTIATE_TEST_SUITE_P(kinds, Extremes,
                         testing::Values("mean_value", "quad_mean_value", "spherical_mean_value", "maximum_entropy"));

// Second derivatives of the vertices' part are of the size of 2^1330 there, beyond the range: infinite with their sign.
TEST(extremes, second_derivatives_in_tiny_cages_are_infinite_with_their_sign) {
  const Vec point(.25, .375, .125);
  for (const char* name : {"green", "biharmonic", "somigliana"}) {
    const auto& kind = *find_coordinate_kind(name);
    const auto large = CageCoordinates(cube(true), kind, CoordinateOptions{}).at<double>(point, 2);
    const auto tiny =
        CageCoordinates(cube(true, -665), kind, CoordinateOptions{}).at<double>(std::ldexp(1., -665) * point, 2);
    int infinite = 0;
    for (std::size_t i = 0; i < large[0].hessian.size(); ++i) {
      const double expected = large[0].hessian[i], found = tiny[0].hessian[i];
      ASSERT_FALSE(std::isnan(found)) << name << ' ' << i;
      if (std::abs(expected) < 1e-12) continue;
      infinite += std::isinf(found);
      EXPECT_EQ(std::signbit(found), std::signbit(expected)) << name << ' ' << i;
    }
    EXPECT_GT(infinite, 10) << name;
  }
}

TEST(extremes, harmonic_coordinates_tell_the_sides_apart) {
  const Cage cage = cube(true);
  const CageCoordinates green(cage, *find_coordinate_kind("green"), CoordinateOptions{});
  for (const double d : {5e-324, 1e-310, 1e-200, 1e-162, 1e-80})
    for (const Vec& point : points_at(d)) {
      const bool inside = (point.array() >= 0).all() && (point.array() <= 1).all();
      double sum = 0;
      const std::vector<double> phi = green.at<double>(point, 0)[0].value;
      for (const double x : phi) sum += x;
      EXPECT_NEAR(sum, inside ? 1 : 0, 1e-14) << point.transpose();
    }
}

}  // namespace
}  // namespace cageproof::adaptive_qmvc
