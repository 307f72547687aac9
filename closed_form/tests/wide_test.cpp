// SPDX-License-Identifier: MIT
#include "cageproof/closed_form/triangle/engine/exact_frame.h"
#include "cageproof/core/numbers/random_stream.h"

#include <gtest/gtest.h>

namespace cageproof::closed_form::wide_test {
namespace {

Mp100 exact(const DoubleDouble& x) { return Mp100(x.high) + Mp100(x.low); }

TEST(double_double, differences_of_doubles_are_exact) {
  for (int i = 0; i < 1000; ++i) {
    RandomStream random(7, "wide", i);
    const double a = random.uniform(-1, 1), b = random.uniform(-1, 1) * std::pow(2.0, random.below(60) - 30);
    EXPECT_TRUE(exact(DoubleDouble::sum(a, -b)) == Mp100(a) - Mp100(b));
  }
}

TEST(double_double, sums_and_products_keep_a_hundred_bits) {
  for (int i = 0; i < 1000; ++i) {
    RandomStream random(8, "wide", i);
    const DoubleDouble a(random.uniform(-1, 1), random.uniform(-1, 1) * 0x1p-54);
    const DoubleDouble b(random.uniform(-1, 1), random.uniform(-1, 1) * 0x1p-54);
    EXPECT_TRUE(abs(exact(a + b) - (exact(a) + exact(b))) <= Mp100(0x1p-102));
    EXPECT_TRUE(abs(exact(a * b) - exact(a) * exact(b)) <= Mp100(0x1p-100));
  }
}

TEST(frame, the_side_of_the_plane_and_of_the_edges_is_exact) {
  // Points computed on the triangle lie an ulp off it, or exactly on it.
  int exact_hits = 0;
  for (int i = 0; i < 4000; ++i) {
    RandomStream random(9, "wide", i);
    Triangle<double> t;
    for (auto& v : t) v = {random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
    const double a = i % 2 == 0 ? 0.3 : 0.0;
    const Vec3<double> eta = a * t[0] + 0.25 * t[1] + (0.75 - a) * t[2];
    const triangle::Frame<double> frame(t, eta);
    const Vec3<Mp200> p0 = convert<Mp200>(t[0]), p1 = convert<Mp200>(t[1]), p2 = convert<Mp200>(t[2]);
    const Vec3<Mp200> x = convert<Mp200>(eta);
    const Vec3<Mp200> normal = Vec3<Mp200>(p1 - p0).cross(Vec3<Mp200>(p2 - p0));
    const Mp200 height = normal.dot(Vec3<Mp200>(x - p0));
    const Mp200 beside = Vec3<Mp200>(p2 - p1).cross(normal).dot(Vec3<Mp200>(p1 - x));
    EXPECT_EQ(frame.d > 0, height > 0);
    EXPECT_EQ(frame.d == 0, height == 0);
    EXPECT_EQ(frame.edges[1].h > 0, beside > 0);
    EXPECT_EQ(frame.edges[1].h == 0, beside == 0);
    exact_hits += height == 0;
  }
  EXPECT_GT(exact_hits, 0);
}

}  // namespace
}  // namespace cageproof::closed_form::wide_test
