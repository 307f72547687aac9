// SPDX-License-Identifier: MIT
#include "quads.h"

#include "quad/mean_value/riemann/misprints.h"

#include <gtest/gtest.h>

namespace cageproof::adaptive_qmvc {
namespace {

using Real = double;

TEST(Projection, LeavesPointsOfTheQuadWhereTheyAre) {
  double worst = 0;
  for (int i = 0; i < 2000; ++i) {
    RandomStream random(1, "on-quad", i);
    const Quad<Real> q = random_valid_quad(random);
    const double u = random.uniform(), v = random.uniform();
    const PairFrame<Real> s(q, combined(q, basis_at(u, v)));
    const auto [pu, pv] = project(s, null_vector(s));
    worst = std::max({worst, std::abs(pu - u), std::abs(pv - v)});
  }
  RecordProperty("worst", std::to_string(worst));
  EXPECT_LT(worst, 1e-12);
}

// Lemma 3.1, before clamping: the line through the point on the hull meets the quad.
TEST(Projection, MeetsValidQuadsWithinTheirBorders) {
  int inner = 0;
  double excess = 0, on_line = 0;
  for (int i = 0; i < 4000; ++i) {
    RandomStream random(2, "hull", i);
    const Quad<Real> q = random_valid_quad(random);
    Vec3<Real> eta = random_point(random, 1.5);
    if (i % 2 == 0) {
      Vec4<Real> b(random.uniform(), random.uniform(), random.uniform(), random.uniform());
      eta = combined(q, Vec4<Real>(b / b.sum()));
    }
    const PairFrame<Real> s(q, eta);
    const Vec4<Real> kappa = null_vector(s);
    inner += inside_hull(kappa);
    const Vec3<Real> step = inside_hull(kappa) ? Vec3<Real>(Vec3<Real>::Zero()) : to_hull(s, kappa);
    const PairFrame<Real> on_hull = s.moved(step);
    const Vec3<Real> d = mean_vector(on_hull).normalized();
    const auto [u, v] = project(s, kappa);
    ASSERT_TRUE(u >= 0 && u <= 1 && v >= 0 && v <= 1);
    const Vec3<Real> x = combined(on_hull.p, basis_at(u, v));
    on_line = std::max(on_line, x.cross(d).norm());
    // Apart from rounding, the hull's own coordinates, through the null vector there, are not negative.
    const Vec4<Real> k = null_vector(on_hull);
    excess = std::max(excess, -(k / k.sum()).minCoeff());
  }
  EXPECT_GE(inner, 2000);
  EXPECT_LT(excess, 1e-8);
  EXPECT_LT(on_line, 1e-12);  // clamping would have moved it off the line
}

TEST(Projection, SolvesQuadraticsWithoutCancellation) {
  for (const double tiny : {1e-3, 1e-9, 1e-17}) {
    // (v - tiny)(v + 1)
    const auto roots = quadratic_roots(1., 1 - tiny, -tiny);
    const double root = std::abs(roots[0]) < std::abs(roots[1]) ? roots[0] : roots[1];
    EXPECT_NEAR(root / tiny, 1, 1e-14);
  }
  EXPECT_EQ(quadratic_roots(0., 2., -1.)[0], .5);
  // A double root at zero; and where every v is one, the middle.
  EXPECT_EQ(quadratic_roots(3., 0., 0.), (std::array<double, 2>{0, 0}));
  EXPECT_EQ(quadratic_roots(0., 0., 0.), (std::array<double, 2>{.5, .5}));
}

// Eq 25: the absolute triangle weights are the integrals with exponent 4; those with the printed 3 are not in
// proportion.
TEST(Misprints, HullKernelNeedsTheFourthPower) {
  const Quad<Real> q = lifted_square(.5);
  const std::array<Vec3<Real>, 3> t{q[0], q[1], q[3]};
  const Vec3<Real> eta(.3, .4, -1.2);
  const auto& rule = gauss_legendre<double>(40);
  const PairFrame<Real> s(q, eta);
  const auto m = face_mean_vectors(s)[0];
  const std::array<Pair, 3> opposite{k13, k03, k01};
  Vec3<Real> closed;
  for (int c = 0; c < 3; ++c) closed[c] = std::abs(m.dot(s.cross[opposite[c]]) / null_vector(s)[2]) / s.unit;
  const Vec3<Real> four = as_printed::face_weights(t, eta, 4, rule), three = as_printed::face_weights(t, eta, 3, rule);
  EXPECT_LT((four - closed).norm() / closed.norm(), 1e-13);
  const Vec3<Real> ratio = three.cwiseQuotient(closed);
  std::printf("Eq 25: weights with exponent 3 over those with 4: %.4f to %.4f\n", ratio.minCoeff(), ratio.maxCoeff());
  EXPECT_GT(std::abs(ratio[0] - 1), .1);
}

TEST(Misprints, HullProjectionNeedsItsSum) {
  int with = 0, without = 0, outer = 0;
  std::vector<double> moved;
  for (int i = 0; i < 2000; ++i) {
    RandomStream random(3, "sum", i);
    Quad<Real> q = random_valid_quad(random);
    // The printed sum depends on the origin, which is therefore put elsewhere than into the quads.
    const Vec3<Real> move = random_point(random, 1);
    for (auto& corner : q) corner += move;
    const Vec3<Real> eta = move + random_point(random, 1.5);
    const PairFrame<Real> s(q, eta);
    const Vec4<Real> kappa = null_vector(s);
    if (inside_hull(kappa)) continue;
    ++outer;
    const auto within = [&](const Vec3<Real>& x) {
      const Vec4<Real> k = null_vector(PairFrame<Real>(q, x));
      return (k / k.sum()).minCoeff() > -1e-9;
    };
    const Vec3<Real> right = eta + s.unit * to_hull(s, kappa), printed = as_printed::to_hull(s, q);
    with += within(right);
    without += within(printed);
    moved.push_back((printed - right).norm());
  }
  std::ranges::sort(moved);
  std::printf("Algorithm 1: in the hull %d of %d, as printed %d; median displacement %.2f\n", with, outer, without,
              moved[moved.size() / 2]);
  EXPECT_EQ(with, outer);
  EXPECT_LT(without, outer / 2);
}

TEST(Misprints, RowParameterNeedsItsDivision) {
  double worst = 0, printed = 0;
  for (int i = 0; i < 500; ++i) {
    RandomStream random(4, "row", i);
    Quad<Real> q = random_valid_quad(random);
    for (auto& corner : q) corner *= 2;
    const double u = random.uniform(.1, .9), v = random.uniform(.1, .9);
    const Vec3<Real> x = combined(q, basis_at(u, v));
    const PairFrame<Real> s(q, x);
    const Vec3<Real> e = (s.p[1] + v * s.along[k12]) - (s.p[0] + v * s.along[k03]);
    const double bare = as_printed::row_parameter(s, v, Vec3<Real>(Vec3<Real>::Zero()));
    printed = std::max(printed, std::abs(bare - u));
    worst = std::max(worst, std::abs(bare / (e.squaredNorm() * s.unit * s.unit) - u));
  }
  std::printf("Eq 29: u off by %.1e, as printed by %.2f\n", worst, printed);
  EXPECT_LT(worst, 1e-13);
  EXPECT_GT(printed, 1);
}

TEST(Misprints, MembershipTestDividesByZeroForPlanarQuads) {
  const Quad<Real> q = lifted_square(0);
  const Vec4<Real> k = null_vector(PairFrame<Real>(q, Vec3<Real>(.25, .5, 1)));
  EXPECT_EQ(k.sum(), 0);
  EXPECT_GT(k.norm(), 0);
  EXPECT_FALSE(std::isfinite(as_printed::parameters_of_kernel(k).first));
}

}  // namespace
}  // namespace cageproof::adaptive_qmvc
