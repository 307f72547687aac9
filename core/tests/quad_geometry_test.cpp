// SPDX-License-Identifier: MIT
#include "cageproof/core/geometry/quad_geometry.h"

#include "cageproof/core/numbers/random_stream.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace cageproof::quad_geometry_test {
namespace {

using Vec = Vec3<double>;
using Q = Quad<double>;

const Q kSquare{Vec(0, 0, 0), Vec(1, 0, 0), Vec(1, 1, 0), Vec(0, 1, 0)};
const Q kTwisted{Vec(0, 0, 0), Vec(1, 0, 0), Vec(1, 1, 0.5), Vec(0, 1, 0)};
const Q kBowTie{Vec(0, 0, 0), Vec(1, 0, 0), Vec(0, 1, 0), Vec(1, 1, 0)};
const Q kArrowhead{Vec(0, 0, 0), Vec(2, -1, 0), Vec(1, 0, 0), Vec(2, 1, 0)};

void expect_reason(const Q& q, const std::string& part) {
  const auto reason = invalid_because(q);
  ASSERT_TRUE(reason.has_value()) << part;
  EXPECT_NE(reason->find(part), std::string::npos) << *reason;
}

Vec at(const Q& q, const BilinearPoint& p) {
  return p.basis[0] * q[0] + p.basis[1] * q[1] + p.basis[2] * q[2] + p.basis[3] * q[3];
}

Vec at(const Q& q, double u, double v) {
  return (1 - u) * (1 - v) * q[0] + u * (1 - v) * q[1] + u * v * q[2] + (1 - u) * v * q[3];
}

void expect_on(const Q& q, const Vec& point, double u, double v) {
  const auto found = on_quad(q, point);
  ASSERT_TRUE(found.has_value()) << u << ' ' << v;
  EXPECT_NEAR(found->u, u, 1e-15);
  EXPECT_NEAR(found->v, v, 1e-15);
  EXPECT_LE((at(q, *found) - point).norm(), 1e-15);
}

// Corners on a grid, so that points with parameters in quarters are exact.
Q random_quad(int i, bool flat) {
  RandomStream random(5, "quad", i);
  Q q;
  for (Vec& corner : q) {
    for (int c = 0; c < 3; ++c) corner[c] = random.below(65) - 32;
    if (flat) corner[2] = corner[0] - 2 * corner[1];
  }
  return q;
}

TEST(quad_validity, planar_and_twisted_quads) {
  EXPECT_EQ(invalid_because(kSquare), std::nullopt);
  EXPECT_EQ(invalid_because(kTwisted), std::nullopt);
  EXPECT_TRUE(is_planar(kSquare));
  EXPECT_FALSE(is_planar(kTwisted));
  EXPECT_TRUE(is_planar(kBowTie));
}

TEST(quad_validity, faults_by_name) {
  expect_reason({kSquare[0], kSquare[1], kSquare[0], kSquare[3]}, "corners 0 and 2 coincide");
  expect_reason({Vec(0, 0, 0), Vec(1, 0, 0), Vec(2, 0, 0), Vec(1, 1, 0)}, "corners 0, 1 and 2 lie on a line");
  expect_reason({Vec(1, 0, 0), Vec(2, 0, 0), Vec(1, 1, 0), Vec(0, 0, 0)}, "corners 3, 0 and 1 lie on a line");
  expect_reason({Vec(2, 0, 0), Vec(1, 1, 0), Vec(0, 0, 0), Vec(1, 0, 0)}, "corners 2, 3 and 0 lie on a line");
  expect_reason(kBowTie, "bow-tie");
  expect_reason(kArrowhead, "folds over");
  for (const double wrong : {std::nan(""), std::numeric_limits<double>::infinity()})
    expect_reason({kSquare[0], kSquare[1], Vec(1, wrong, 0), kSquare[3]}, "not finite");
}

// A roof folded along its diagonal: valid up to a right angle, of which one half's projection is a line.
TEST(quad_validity, ends_at_a_fold_of_a_right_angle) {
  for (const double unit : {1e-200, 1.0, 1e150}) {
    const auto roof = [&](double opening) {
      return Q{Vec(-unit, 0, 0), Vec(0, -unit, 0), Vec(unit, 0, 0), Vec(0, opening * unit, unit)};
    };
    EXPECT_EQ(invalid_because(roof(0x1p-60)), std::nullopt) << unit;
    expect_reason(roof(0), "folds over");
    expect_reason(roof(-0x1p-60), "folds over");
  }
}

TEST(quad_validity, one_ulp_decides) {
  Q q{Vec(0, 0, 0), Vec(1, 0, 0), Vec(0.1, 0.1, 0), Vec(0, 1, 0)};
  q[2] = Vec(0.5, 0.5, 0);
  expect_reason(q, "lie on a line");
  q[2][0] = std::nextafter(0.5, 1);
  EXPECT_EQ(invalid_because(q), std::nullopt);
  q[2][0] = std::nextafter(0.5, 0);
  expect_reason(q, "folds over");
  EXPECT_TRUE(is_planar(q));
  q[2][2] = 1e-300;
  EXPECT_FALSE(is_planar(q));
}

// Strictly convex seen along all four normals, in 200 digits.
TEST(quad_validity, agrees_with_its_definition) {
  int valid = 0;
  for (int i = 0; i < 3000; ++i) {
    const Q q = random_quad(i, i % 2 == 0);
    std::array<Vec3<Mp200>, 4> p, n;
    for (int k = 0; k < 4; ++k) p[k] = convert<Mp200>(q[k]);
    for (int k = 0; k < 4; ++k) n[k] = Vec3<Mp200>(p[k] - p[(k + 3) % 4]).cross(Vec3<Mp200>(p[(k + 1) % 4] - p[k]));
    bool convex = true;
    for (int a = 0; a < 4; ++a)
      for (int b = 0; b < 4; ++b) convex = convex && n[a].dot(n[b]) > 0;
    EXPECT_EQ(!invalid_because(q), convex);
    valid += convex;
  }
  EXPECT_GT(valid, 200);
}

TEST(on_quad, exact_points_of_valid_quads) {
  int valid = 0;
  for (int i = 0; i < 2000; ++i) {
    const Q q = random_quad(i, i % 2 == 0);
    if (invalid_because(q)) continue;
    ++valid;
    for (const double u : {0.0, 0.25, 0.5, 1.0})
      for (const double v : {0.0, 0.5, 0.75, 1.0}) {
        const Vec point = at(q, u, v);
        const auto found = on_quad(q, point);
        ASSERT_TRUE(found.has_value()) << i;
        EXPECT_NEAR(found->u, u, 1e-15);
        EXPECT_NEAR(found->v, v, 1e-15);
        for (int c = 0; c < 3; ++c) {
          Vec off = point;
          off[c] = std::nextafter(off[c], 100.0);
          const auto near = on_quad(q, off);
          if (!is_planar(q)) {
            EXPECT_FALSE(near && std::abs(near->u - u) + std::abs(near->v - v) > 1e-12);
          } else {
            EXPECT_FALSE(near.has_value());
          }
        }
      }
  }
  EXPECT_GT(valid, 200);
}

TEST(on_quad, one_ulp_off) {
  expect_on(kTwisted, Vec(0.5, 0.5, 0.125), 0.5, 0.5);
  for (const double to : {0.0, 1.0}) {
    EXPECT_FALSE(on_quad(kTwisted, Vec(0.5, 0.5, std::nextafter(0.125, to))));
    EXPECT_FALSE(on_quad(kTwisted, Vec(std::nextafter(0.5, to), 0.5, 0.125)));
  }
  expect_on(kSquare, Vec(1, 0.3, 0), 1, 0.3);
  EXPECT_FALSE(on_quad(kSquare, Vec(std::nextafter(1.0, 2), 0.3, 0)));
  EXPECT_FALSE(on_quad(kSquare, Vec(0.3, 0.3, 1e-300)));
  // In the tetrahedron's planes and beyond the border, where the kernel is a product of negative factors.
  EXPECT_FALSE(on_quad(kTwisted, at(kTwisted, 1.5, 0.5)));
  EXPECT_FALSE(on_quad(kTwisted, Vec(std::nan(""), 0.5, 0.125)));
}

TEST(on_quad, numbers_that_are_no_doubles) {
  using Wide = Vec3<Mp200>;
  const Mp200 third = Mp200(1) / 3, least("1e-190"), tenth("0.1");
  const auto in_parts = [](const Q& q, const Mp200& unit) {
    Quad<Mp200> result;
    for (int k = 0; k < 4; ++k) result[k] = unit * convert<Mp200>(q[k]);
    return result;
  };
  const Quad<Mp200> square = in_parts(kSquare, Mp200(3)), twisted = in_parts(kTwisted, Mp200(1));
  for (const Mp200& x : {third, tenth}) {
    const auto found = on_quad(square, Wide(x, tenth, 0));
    ASSERT_TRUE(found);
    EXPECT_NEAR(found->u, static_cast<double>(x) / 3, 1e-16);
    EXPECT_NEAR(found->v, 0.1 / 3, 1e-16);
    EXPECT_FALSE(on_quad(square, Wide(x, tenth, least)));
    EXPECT_TRUE(on_quad(square, Wide(x, 0, 0)));
    EXPECT_FALSE(on_quad(square, Wide(x, -least, 0)));
  }
  ASSERT_TRUE(on_quad(twisted, Wide(0.5, 0.5, 0.125)));
  EXPECT_FALSE(on_quad(twisted, Wide(0.5, 0.5, Mp200(0.125) + least)));
  EXPECT_FALSE(on_quad(square, Wide(third, tenth, Mp200("1e-100000"))));
  EXPECT_FALSE(on_quad(square, Wide(std::numeric_limits<Mp200>::infinity(), tenth, 0)));
}

TEST(on_quad, any_unit) {
  for (const double unit : {0x1p-600, 0x1p-150, 1.0, 0x1p150, 0x1p500}) {
    Q twisted = kTwisted, flat = kSquare;
    for (int i = 0; i < 4; ++i) twisted[i] *= unit, flat[i] *= unit;
    const auto found = on_quad(twisted, Vec(0.5, 0.5, 0.125) * unit);
    ASSERT_TRUE(found) << unit;
    EXPECT_EQ(found->basis, (std::array{0.25, 0.25, 0.25, 0.25}));
    ASSERT_TRUE(on_quad(flat, Vec(0.5, 0.25, 0) * unit)) << unit;
    EXPECT_FALSE(on_quad(twisted, Vec(0.5, 0.5, 0.25) * unit)) << unit;
  }
}

// [T18] Eq 19 with signed areas A_i of (x, q_i, q_i+1) and B_i of (x, q_i-1, q_i+1).
TEST(on_quad, agrees_with_the_papers_equation_in_the_plane) {
  int asked = 0;
  for (int i = 0; i < 2000; ++i) {
    const Q q = random_quad(i, true);
    if (invalid_because(q)) continue;
    const Vec x = at(q, 0.375, 0.625), n = (q[2] - q[0]).cross(q[3] - q[1]).normalized();
    const auto area = [&](int a, int b) { return Vec(q[(a + 4) % 4] - x).cross(q[(b + 4) % 4] - x).dot(n); };
    const auto A = [&](int k) { return area(k, k + 1); };
    const auto B = [&](int k) { return area(k - 1, k + 1); };
    const double root = std::sqrt(B(0) * B(0) + B(1) * B(1) + 2 * A(0) * A(2) + 2 * A(1) * A(3));
    const auto E = [&](int k) { return 2 * A(k) - B(k) - B(k + 1) + root; };
    const auto found = on_quad(q, x);
    ASSERT_TRUE(found);
    EXPECT_NEAR(found->u, 2 * A(3) / E(3), 1e-10);
    EXPECT_NEAR(found->v, 2 * A(0) / E(0), 1e-10);
    ++asked;
  }
  EXPECT_GT(asked, 100);
}

TEST(on_quad, invalid_quads_reproduce_what_they_cover) {
  for (int i = 0; i < 2000; ++i) {
    const Q q = random_quad(i, i % 4 != 0);
    for (const double u : {0.0, 0.25, 0.5, 0.75, 1.0})
      for (const double v : {0.0, 0.25, 0.5, 1.0}) {
        const auto found = on_quad(q, at(q, u, v));
        ASSERT_TRUE(found) << i << ' ' << u << ' ' << v;
        EXPECT_LE((at(q, *found) - at(q, u, v)).norm(), 1e-13);
      }
  }
  // Two rows cover the arrowhead's points; beside it there is nothing.
  ASSERT_TRUE(on_quad(kArrowhead, Vec(0.25, 0, 0)));
  EXPECT_FALSE(on_quad(kArrowhead, Vec(1.75, 0, 0)));
  EXPECT_FALSE(on_quad(kBowTie, Vec(0.1, 0.5, 0)));
  ASSERT_TRUE(on_quad(kBowTie, Vec(0.5, 0.5, 0)));
}

TEST(on_quad, degenerate_quads) {
  const Vec a(0, 0, 0), b(1, 2, 3), c(2, 4, 6), d(3, 6, 9);
  for (const Q& q : {Q{a, b, c, d}, Q{a, c, b, d}, Q{a, a, d, d}}) {
    const auto found = on_quad(q, c);
    ASSERT_TRUE(found);
    EXPECT_LE((at(q, *found) - c).norm(), 1e-15);
    EXPECT_FALSE(on_quad(q, Vec(1, 2, 3.5)));
  }
  EXPECT_TRUE(on_quad({b, b, b, b}, b));
  EXPECT_FALSE(on_quad({b, b, b, b}, a));
}

}  // namespace
}  // namespace cageproof::quad_geometry_test
