// SPDX-License-Identifier: MIT
#include "cageproof/core/geometry/exact_geometry.h"
#include "cageproof/core/geometry/exact_volume.h"
#include "cageproof/core/numbers/random_stream.h"

#include <boost/multiprecision/cpp_int.hpp>

#include <gtest/gtest.h>

namespace cageproof {
namespace {

using Rational = boost::multiprecision::cpp_rational;
using Vector = std::array<Rational, 3>;

Vector from(const Vec3<double>& v) { return {Rational(v[0]), Rational(v[1]), Rational(v[2])}; }
Vector minus(const Vector& a, const Vector& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
Rational dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

// Whether x is the rational number to 200 digits.
::testing::AssertionResult is(const Mp200& x, const Rational& exact) {
  const Mp200 quotient = Mp200(numerator(exact).str()) / Mp200(denominator(exact).str());
  if (quotient.is_zero()) {
    if (x.is_zero()) return ::testing::AssertionSuccess();
    return ::testing::AssertionFailure() << x << " instead of zero";
  }
  const Mp200 error = abs(x - quotient) / abs(quotient);
  if (error <= Mp200("1e-198")) return ::testing::AssertionSuccess();
  return ::testing::AssertionFailure() << "relative error " << error;
}

void expect_exact(const Triangle<double>& t, const Vec3<double>& point) {
  const ExactTriangle exact({convert<Mp200>(t[0]), convert<Mp200>(t[1]), convert<Mp200>(t[2])}, convert<Mp200>(point));
  const Vector e0 = minus(from(t[1]), from(t[0])), e1 = minus(from(t[2]), from(t[1])), normal = cross(e0, e1);
  EXPECT_TRUE(is(exact.volume, dot(normal, minus(from(t[2]), from(point)))));
  for (int i = 0; i < 3; ++i) {
    const Vector start = minus(from(t[i]), from(point)), end = minus(from(t[(i + 1) % 3]), from(point));
    const Vector edge = minus(end, start), outward = cross(edge, normal);
    EXPECT_TRUE(is(exact.beside[i], dot(outward, end)));
    EXPECT_TRUE(is(exact.before[i], dot(edge, start)));
    EXPECT_TRUE(is(exact.after[i], dot(edge, end)));
    for (int c = 0; c < 3; ++c) {
      EXPECT_TRUE(is(exact.p[i][c], start[c]));
      EXPECT_TRUE(is(exact.e[i][c], edge[c]));
      EXPECT_TRUE(is(exact.normal[c], normal[c]));
      EXPECT_TRUE(is(exact.outward[i][c], outward[c]));
    }
  }
}

// Whether the sign is the rational number's, and the size its double to two roundings, wherever that is a normal one.
::testing::AssertionResult is_rounded(double size, int sign, const Rational& exact) {
  const int truly = exact > 0 ? 1 : exact < 0 ? -1 : 0;
  if (sign != truly) return ::testing::AssertionFailure() << "sign " << sign << " instead of " << truly;
  if (!std::isnormal(size)) return ::testing::AssertionSuccess();
  const Rational error = abs(Rational(size) - exact), allowed = abs(exact) * Rational(0x1p-52);
  if (error <= allowed) return ::testing::AssertionSuccess();
  return ::testing::AssertionFailure() << size << " is off by " << static_cast<double>(error);
}

void expect_heights(const Triangle<double>& t, const Vec3<double>& point, int exponent = 0) {
  const ExactHeights heights = exact_heights(t, point, exponent);
  const Rational unit(std::ldexp(1., exponent));
  const Vector e0 = minus(from(t[1]), from(t[0])), e1 = minus(from(t[2]), from(t[1])), normal = cross(e0, e1);
  const Rational volume = dot(normal, minus(from(t[2]), from(point)));
  EXPECT_TRUE(is_rounded(heights.volume, heights.volume_sign, volume / (unit * unit * unit)));
  EXPECT_TRUE(is_rounded(exact_volume(t, point, exponent), heights.volume_sign, volume / (unit * unit * unit)));
  for (int i = 0; i < 3; ++i) {
    const Vector edge = minus(from(t[(i + 1) % 3]), from(t[i]));
    const Rational beside = dot(cross(edge, normal), minus(from(t[i]), from(point)));
    EXPECT_TRUE(is_rounded(heights.beside[i], heights.beside_sign[i], beside / (unit * unit * unit * unit)));
  }
}

TEST(exact_heights, are_rational_arithmetics) {
  constexpr double kLeast = std::numeric_limits<double>::denorm_min();
  expect_heights({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}}, {.25, .375, 0});
  expect_heights({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}}, {.5, .5, 0});
  expect_heights({{{3, 5, 7}, {9, -2, 4}, {-1, 8, 2}}}, {2, 1, 5}, 3);
  expect_heights({{{.1, .7, -.3}, {.9, .2, .4}, {.3, -.8, .6}}}, {.3, 1e-16, -.2}, -2);
  // Widths: that of the integers, one bit more, much more, and the whole range.
  for (const int wide : {0, -1, -30, -60}) {
    const double small = std::ldexp(0x1.fedcba9876543p0, wide), large = 0x1.fedcba9876541p59;
    expect_heights({{{large, small, -large}, {-0.7 * large, -large, small}, {-small, 0.9 * large, large}}},
                   {0.8 * large, -0.6 * large, -small});
  }
  expect_heights({{{0, 0, 0}, {0, 0, 0}, {0, 0, 0}}}, {0, 0, 0});
  expect_heights({{{.1, .7, -.3}, {1e300, 0, 0}, {0, 1e-300, kLeast}}}, {.3, -1e-200, 1e200}, 900);
  expect_heights({{{1, -1, 0}, {0, 1, -1}, {-1, 0, 1}}}, {1e-250, 0, 0});
  // Points computed on the triangle lie a rounding off it, or exactly on it.
  for (int i = 0; i < 200; ++i) {
    RandomStream random(5, "heights", i);
    Triangle<double> t;
    for (auto& v : t) v = {random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
    const double a = random.uniform();
    expect_heights(t, a * t[0] + .25 * t[1] + (.75 - a) * t[2], 1);
  }
}

TEST(exact_geometry, products_are_rational_arithmetics) {
  constexpr double kLeast = std::numeric_limits<double>::denorm_min();
  expect_exact({{{1, -1, 0}, {0, 1, -1}, {-1, 0, 1}}}, {1e-250, 0, 0});
  expect_exact({{{1, -1, 0}, {0, 1, -1}, {-1, 0, 1}}}, {-1e-250, 0, 0});
  expect_exact({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}}, {.25, .375, kLeast});
  expect_exact({{{.1, .7, -.3}, {1e300, 0, 0}, {0, 1e-300, kLeast}}}, {.3, -1e-200, 1e200});
  expect_exact({{{kLeast, 0, 0}, {0, kLeast, 0}, {0, 0, kLeast}}}, {kLeast, kLeast, kLeast});
}

TEST(exact_geometry, a_point_in_the_plane_has_no_volume) {
  const ExactTriangle exact({{{1, -1, 0}, {0, 1, -1}, {-1, 0, 1}}}, {Mp200(1e-250), Mp200(-1e-250), Mp200(0)});
  EXPECT_TRUE(exact.volume.is_zero());
}

TEST(exact_geometry, segments_are_rational_arithmetics) {
  const auto expect = [](const Segment<double>& s, const Vec3<double>& point) {
    const ExactSegment exact({convert<Mp200>(s[0]), convert<Mp200>(s[1])}, convert<Mp200>(point));
    const Vector start = minus(from(s[0]), from(point)), end = minus(from(s[1]), from(point));
    const Vector e = minus(end, start);
    EXPECT_TRUE(is(exact.cross, e[0] * end[1] - e[1] * end[0]));
    EXPECT_TRUE(is(exact.before, e[0] * start[0] + e[1] * start[1]));
    EXPECT_TRUE(is(exact.after, e[0] * end[0] + e[1] * end[1]));
    EXPECT_TRUE(is(exact.p[1][0], end[0]));
  };
  expect({{{1, -1, 0}, {-1, 1, 0}}}, {1e-250, 0, 0});
  expect({{{.1, -1e-300, 0}, {1e300, 1, 0}}}, {5e-324, .7, 0});
}

TEST(exact_geometry, numbers_without_common_scale_are_rounded) {
  const Mp200 tiny("1e-20000");
  const ExactTriangle exact({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}}, {Mp200(.25), Mp200(.25), tiny});
  EXPECT_EQ(exact.volume, -tiny);
  const ExactTriangle none({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}},
                           {Mp200(.25), Mp200(.25), std::numeric_limits<Mp200>::quiet_NaN()});
  EXPECT_TRUE(isnan(none.volume));
}

}  // namespace
}  // namespace cageproof
