// SPDX-License-Identifier: MIT
#include "cageproof/core/geometry/orientation.h"
#include "cageproof/core/numbers/random_stream.h"

#include <gtest/gtest.h>

#include <cmath>

namespace cageproof {
namespace {

using Vec = Vec3<double>;

// The determinant in 200 digits, which hold the products of three doubles of similar size exactly.
int exact_side(const Triangle<double>& t, const Vec& p) {
  const Vec3<Mp200> a = convert<Mp200>(t[0]), b = convert<Mp200>(t[1]), c = convert<Mp200>(t[2]), x = convert<Mp200>(p);
  const Mp200 det = Vec3<Mp200>(b - a).cross(Vec3<Mp200>(c - a)).dot(Vec3<Mp200>(x - a));
  return det > 0 ? 1 : det < 0 ? -1 : 0;
}

TEST(side_of_plane, exact_next_to_the_plane) {
  std::array<int, 3> seen{};
  for (int i = 0; i < 3000; ++i) {
    RandomStream random(11, "orientation", i);
    Triangle<double> t;
    for (Vec& v : t) v = {random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
    if (i % 3 == 0)
      for (Vec& v : t) v = (v * 64).array().round() / 64;
    if (t[1] == t[0] || t[2] == t[0] || t[1] == t[2]) continue;
    Vec p = 0.25 * t[0] + 0.25 * t[1] + 0.5 * t[2];
    if (i % 2 == 0) p[i % 3] = std::nextafter(p[i % 3], i % 4 == 0 ? 2 : -2);
    const int side = side_of_plane(t, p);
    EXPECT_EQ(side, exact_side(t, p));
    ++seen[side + 1];
  }
  for (const int count : seen) EXPECT_GT(count, 100);
}

TEST(side_of_plane, positive_where_the_normal_points_in_any_unit) {
  for (const double unit : {1e-100, 1.0, 1e100}) {
    const Triangle<double> t{Vec(0, 0, 0), Vec(unit, 0, 0), Vec(0, unit, 0)};
    EXPECT_EQ(side_of_plane(t, Vec(0, 0, 1e-150)), 1);
    EXPECT_EQ(side_of_plane(t, Vec(unit, unit, -1e-150)), -1);
    EXPECT_EQ(side_of_plane(t, Vec(7 * unit, -3 * unit, 0)), 0);
  }
}

TEST(side_of_edge, a_triangle_without_area_has_no_sides) {
  for (const Triangle<double>& t : {Triangle<double>{Vec(0, 0, 0), Vec(1, 1, 1), Vec(3, 3, 3)},
                                    Triangle<double>{Vec(1, 0, 0), Vec(1, 0, 0), Vec(0, 1, 0)}})
    for (int edge = 0; edge < 3; ++edge)
      for (const Vec& point : {Vec(2, 2, 2), Vec(0.25, 0.5, 1), Vec(1, 0, 0)})
        EXPECT_EQ(side_of_edge(t, edge, point), 0);
}

TEST(side_of_edge, inside_on_the_line_and_beyond) {
  const Triangle<double> t{Vec(0, 0, 1), Vec(1, 0, 1), Vec(0, 1, 1)};
  EXPECT_EQ(side_of_edge(t, 0, Vec(0.25, 1e-300, 1)), 1);
  EXPECT_EQ(side_of_edge(t, 0, Vec(5, 0, 1)), 0);
  EXPECT_EQ(side_of_edge(t, 0, Vec(0.25, -1e-300, 1)), -1);
  EXPECT_EQ(side_of_edge(t, 1, Vec(0.5, 0.5, 1)), 0);
  EXPECT_EQ(side_of_edge(t, 1, Vec(0.5, std::nextafter(0.5, 1), 1)), -1);
  EXPECT_EQ(side_of_edge(t, 2, Vec(0.5, 0.5, 1)), 1);
}

}  // namespace
}  // namespace cageproof
