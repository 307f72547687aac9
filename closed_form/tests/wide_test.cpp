// SPDX-License-Identifier: MIT
#include "cageproof/closed_form/wide.h"
#include "cageproof/core/random_stream.h"

#include <gtest/gtest.h>

namespace cageproof::closed_form {
namespace {

Mp100 exact(const TwoDoubles& x) { return Mp100(x.high) + Mp100(x.low); }

TEST(two_doubles, differences_of_doubles_are_exact) {
  for (int i = 0; i < 1000; ++i) {
    RandomStream random(7, "wide", i);
    const double a = random.uniform(-1, 1), b = random.uniform(-1, 1) * std::pow(2.0, random.below(60) - 30);
    EXPECT_TRUE(exact(TwoDoubles::sum(a, -b)) == Mp100(a) - Mp100(b));
  }
}

TEST(two_doubles, sums_and_products_keep_a_hundred_bits) {
  for (int i = 0; i < 1000; ++i) {
    RandomStream random(8, "wide", i);
    const TwoDoubles a(random.uniform(-1, 1), random.uniform(-1, 1) * 0x1p-54);
    const TwoDoubles b(random.uniform(-1, 1), random.uniform(-1, 1) * 0x1p-54);
    EXPECT_TRUE(abs(exact(a + b) - (exact(a) + exact(b))) <= Mp100(0x1p-102));
    EXPECT_TRUE(abs(exact(a * b) - exact(a) * exact(b)) <= Mp100(0x1p-100));
  }
}

TEST(two_doubles, heights_of_points_next_to_a_plane_keep_their_sign) {
  // The plane through the origin is met to the last bit; one ulp decides the side.
  for (int i = 0; i < 1000; ++i) {
    RandomStream random(9, "wide", i);
    Vec3<double> p[3];
    for (auto& v : p) v = {random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
    const Vec3<double> eta = 0.3 * p[0] + 0.3 * p[1] + 0.4 * p[2];
    const auto a = wide_difference<double>(p[1], p[0]), b = wide_difference<double>(p[2], p[0]);
    const double found = static_cast<double>(dot(cross(a, b), wide_difference<double>(eta, p[0])));
    const Vec3<Mp100> A = convert<Mp100>(p[1]) - convert<Mp100>(p[0]), B = convert<Mp100>(p[2]) - convert<Mp100>(p[0]);
    const Mp100 height = A.cross(B).dot(Vec3<Mp100>(convert<Mp100>(eta) - convert<Mp100>(p[0])));
    EXPECT_EQ(found > 0, height > 0);
    EXPECT_NEAR(found, static_cast<double>(height), 1e-12 * std::abs(found));
  }
}

}  // namespace
}  // namespace cageproof::closed_form
