// SPDX-License-Identifier: MIT
#include "quads.h"

#include "quad/mean_value/riemann/misprints.h"
#include "quad/mean_value/riemann/singular_solution.h"

#include <gtest/gtest.h>

namespace cageproof::adaptive_qmvc::riemann_test {
namespace {

template <Scalar R>
void expect_null_vector_and_solution_of_svd(double tolerance) {
  double null_vectors = 0, solutions = 0, printed = 10, unit_null_vector = 0;
  for (int i = 0; i < 50; ++i) {
    RandomStream random(5, "svd", i);
    const PairFrame<R> s(convert_quad<R>(random_valid_quad(random)), convert<R>(random_point(random, 1.5)));
    const Vec3<R> m = mean_vector(s);
    const Vec4<R> k = null_vector(s), w = minimal_norm_solution(s, k, m);
    const auto svd = singular_solution(s, m);
    const R side = svd.null_vector.dot(k) < 0 ? R(-1) : R(1);
    null_vectors =
        std::max(null_vectors, relative_difference<R>(Vec4<R>(k / k.norm()), Vec4<R>(side * svd.null_vector)));
    solutions = std::max(solutions, relative_difference<R>(w, svd.minimal_norm));
    printed = std::min(printed, relative_difference<R>(as_printed::minimal_norm_solution(s, k, m), svd.minimal_norm));
    const Vec4<R> mixed = minimal_norm_solution(s, Vec4<R>(k / k.norm()), m);
    unit_null_vector = std::max(unit_null_vector, relative_difference<R>(mixed, svd.minimal_norm));
  }
  if (std::same_as<R, double>)
    std::printf("Eq 28: against the SVD %.1e, as printed %.2f, with Eq 18's unit null vector %.1f\n", solutions,
                printed, unit_null_vector);
  EXPECT_LT(null_vectors, tolerance);
  EXPECT_LT(solutions, tolerance);
  EXPECT_NEAR(printed, 2, 1e-6);
}
TEST(LinearSolution, IsThatOfTheSvd) {
  expect_null_vector_and_solution_of_svd<double>(1e-9);
  expect_null_vector_and_solution_of_svd<Mp50>(1e-44);
}

template <Scalar R>
double worst_residual(const std::string& name, int count) {
  double worst = 0;
  for (int i = 0; i < count; ++i) {
    RandomStream random(6, "linear", i);
    const Quad<double> q = random_valid_quad(random);
    Vec3<double> eta = random_point(random, 1.5);
    if (i % 2 == 0) {
      const double u = random.uniform(), v = random.uniform();
      eta = combined(q, basis_at(u, v)) + std::pow(10, -random.uniform(0, 10)) * normal_at(q, u, v);
    }
    const Quad<R> wide = convert_quad<R>(q);
    worst = std::max(worst, linear_residual<R>(wide, convert<R>(eta), evaluated<R>(name, wide, convert<R>(eta))));
  }
  return worst;
}
TEST(Weights, OfTheSchemeSolveEquation17) {
  EXPECT_LT(worst_residual<double>("riemann-4", 2000), 1e-13);
  EXPECT_LT(worst_residual<Mp50>("riemann-4", 20), 1e-48);
}
// Next to the plane of a planar quad the matrix of Eq 17 is nearly singular: Eq 28 by itself loses one digit per decade
// of height, 3e-8 at 1e-8.
TEST(Weights, SolveEquation17NextToThePlaneOfAPlanarQuad) {
  double worst = 0;
  for (int i = 0; i < 1500; ++i) {
    RandomStream random(10, "planar", i);
    const auto tilted = [](double x, double y, double z) { return Vec3<double>(x, .6 * y - .8 * z, .8 * y + .6 * z); };
    const Quad<double> q{tilted(0, 0, 0), tilted(1, .1, 0), tilted(1.2, .9, 0), tilted(-.1, 1, 0)};
    const Vec3<double> eta =
        tilted(random.uniform(-.3, 1.3), random.uniform(-.3, 1.3), std::pow(10, -random.uniform(1, 14)));
    worst = std::max(worst, linear_residual<double>(q, eta, evaluated<double>("riemann-4", q, eta)));
  }
  EXPECT_LT(worst, 1e-13);
}
// A triangulation's border is the quad's, so its mean vector is too; and interpolation on triangles keeps linear
// functions.
TEST(Weights, OfTheTessellationSolveEquation17) {
  EXPECT_LT(worst_residual<double>("tessellated-5", 100), 1e-10);
  EXPECT_LT(worst_residual<Mp50>("tessellated-3", 6), 1e-38);
}

TEST(Weights, ConvergeToTheIntegral) {
  RandomStream random(7, "convergence", 0);
  const Quad<double> q = random_valid_quad(random);
  const Vec3<double> eta(.4, -.3, .9);
  const Vec4<double> truth = integrated_weights(q, eta, .5, .5);
  const auto error = [&](const std::string& name) {
    return relative_difference<double>(evaluated<double>(name, q, eta), truth);
  };
  double last = 1;
  for (const int n : {4, 8, 16, 32, 64}) {
    const double now = error("riemann-" + std::to_string(n));
    if (n > 4) {
      EXPECT_NEAR(last / now, 4, .5) << n;
    }
    last = now;
  }
  EXPECT_LT(last, 1e-5);
  EXPECT_NEAR(error("tessellated-16") / error("tessellated-32"), 4, .5);
}

// Next to twisted quads an error remains, whatever n; next to planar ones it vanishes.
double error_above(double twist, double h, int n) {
  const Quad<double> q = lifted_square(twist);
  double worst = 0;
  for (const auto& [u, v] : {std::pair{.35, .6}, {.5, .5}, {.9, .95}})
    for (const double side : {-1., 1.}) {
      const Vec3<double> eta = combined(q, basis_at(u, v)) + side * h * normal_at(q, u, v).normalized();
      const Vec4<double> found = evaluated<double>("riemann-" + std::to_string(n), q, eta);
      worst = std::max(worst, relative_difference<double>(found, integrated_weights(q, eta, u, v)));
    }
  return worst;
}
TEST(Weights, KeepAnErrorNextToTwistedQuads) {
  EXPECT_NEAR(error_above(.2, 1, 4), 1.7e-3, 1e-4);
  EXPECT_NEAR(error_above(.2, .1, 4), 2.2e-2, 1e-3);
  EXPECT_NEAR(error_above(.2, .001, 4), 1.8e-3, 1e-4);
  EXPECT_NEAR(error_above(.2, .001, 10), 1.8e-3, 1e-4);
  EXPECT_NEAR(error_above(.5, .001, 4), 9.7e-3, 2e-4);
  EXPECT_NEAR(error_above(.5, .001, 10), 9.7e-3, 2e-4);
  EXPECT_LT(error_above(0, .001, 4), 1e-6);
}

// [T18] Figure 7: without the norm correction the sum's error grows like one over the square of the distance.
TEST(Weights, DivergeNextToTheQuadWithoutTheNormCorrection) {
  const Quad<double> q = lifted_square(.5);
  double last = 0;
  for (const double h : {1e-3, 1e-4, 1e-5}) {
    const Vec3<double> eta = combined(q, basis_at(.35, .6)) + h * normal_at(q, .35, .6).normalized();
    const Vec4<double> truth = evaluated<double>("line_form", q, eta);
    const double off = relative_difference<double>(evaluated<double>("riemann-4-uncorrected", q, eta), truth);
    if (last > 0) {
      EXPECT_NEAR(off / last, 100, 5) << h;
    }
    EXPECT_LT(relative_difference<double>(evaluated<double>("riemann-4-unguarded", q, eta), truth), .1) << h;
    EXPECT_GT(off, 10) << h;
    last = off;
  }
}

// On an extended diagonal the two triangles on it are seen edge-on, so the mean vector is zero, whatever the quad.
TEST(PoleGuard, BoundsTheWeightsAroundExtendedDiagonals) {
  double zero = 0, bare = 0, guarded = 0, step = 0, uncorrected = 0;
  int poles = 0;
  RiemannWorkspace<double> work;
  PoleGuard off;
  off.correction = NormCorrection::AsPrinted;
  for (int i = 0; i < 200; ++i) {
    RandomStream random(9, "diagonal", i);
    const Quad<double> q = random_valid_quad(random);
    const Vec3<double> on_line = q[0] + random.uniform(1.3, 2) * (q[2] - q[0]);
    zero = std::max(zero, mean_vector(PairFrame<double>(q, on_line)).norm());
    const auto weights = [&](const Vec3<double>& at, const PoleGuard& guard) {
      return quad_weights<double>(q, at, 4, work, guard);
    };
    const double reach = std::pow(10, -random.uniform(0.5, 4));
    const Vec3<double> eta = on_line + random_point(random, reach);
    const PairFrame<double> s(q, eta);
    const Vec4<double> k = null_vector(s), w = weights(eta, {});
    const auto [u, v] = project(s, k);
    poles += omega(s, 4, u, v, work).dot(minimal_norm_solution(s, k, mean_vector(s))) <= 0;
    const Vec4<double> truth = evaluated<double>("line_form", q, eta);
    const Vec4<double> as_printed = weights(eta, off);
    EXPECT_EQ(evaluated<double>("riemann-4-unguarded", q, eta), as_printed);
    bare = std::max(bare, relative_difference<double>(as_printed, truth));
    uncorrected =
        std::max(uncorrected, relative_difference<double>(evaluated<double>("riemann-4-uncorrected", q, eta), truth));
    guarded = std::max(guarded, relative_difference<double>(w, truth));
    step = std::max(step, relative_difference<double>(weights(eta + 1e-7 * random_point(random, 1), {}), w));
  }
  std::printf(
      "around extended diagonals, n = 4: Omega.wbar <= 0 at %d of 200; worst error %.1e guarded, %.1e without\n", poles,
      guarded, bare);
  EXPECT_LT(zero, 1e-14);
  EXPECT_GT(poles, 10);
  EXPECT_GT(bare, 1);
  EXPECT_LT(guarded, .6);
  EXPECT_LT(uncorrected, .3);
  EXPECT_LT(step, 1e-4);
}

TEST(Weights, AreInfiniteOnTheQuadAndZeroInItsPlane) {
  const double inf = std::numeric_limits<double>::infinity();
  const Quad<double> flat = lifted_square(0), bent = lifted_square(.5);
  EXPECT_EQ(evaluated<double>("riemann-4", flat, {.25, .5, 0}), Vec4<double>(inf, inf, inf, inf));
  EXPECT_EQ(evaluated<double>("riemann-4", flat, {.25, 0, 0}), Vec4<double>(inf, inf, 0, 0));
  EXPECT_EQ(evaluated<double>("riemann-4", flat, {1, 1, 0}), Vec4<double>(0, 0, inf, 0));
  EXPECT_EQ(evaluated<double>("riemann-4", flat, {1.25, .5, 0}), Vec4<double>(0, 0, 0, 0));
  EXPECT_EQ(evaluated<double>("riemann-4", bent, {.5, .5, .125}), Vec4<double>(inf, inf, inf, inf));
  const Vec3<Mp50> on_bent(Mp50(.5), Mp50(.5), Mp50(.125));
  EXPECT_TRUE(evaluated<Mp50>("riemann-4", convert_quad<Mp50>(bent), on_bent)[3] ==
              std::numeric_limits<Mp50>::infinity());
  EXPECT_TRUE(evaluated<double>("riemann-4", bent, {.5, .5, .126}).allFinite());
  EXPECT_EQ(evaluated<double>("tessellated-5", flat, {.25, 0, 0}), Vec4<double>(inf, inf, 0, 0));
}

TEST(Weights, ScaleWithTheUnit) {
  RandomStream random(8, "unit", 0);
  Quad<double> q = random_valid_quad(random);
  Vec3<double> eta(.3, .2, .7);
  const Vec4<double> w = evaluated<double>("riemann-4", q, eta);
  for (auto& corner : q) corner *= 0x1p-300;
  EXPECT_EQ(Vec4<double>(evaluated<double>("riemann-4", q, eta * 0x1p-300) * 0x1p-300), w);
}

TEST(Families, TakeCountsFrom1To512) {
  const auto& all = EvaluationRegister::instance();
  for (const char* good :
       {"riemann-1", "riemann-512", "riemann-9-uncorrected", "riemann-9-unguarded", "tessellated-1", "tessellated-512"})
    EXPECT_TRUE(all.find("quad.mean_value", good)) << good;
  for (const char* bad :
       {"riemann-0", "riemann-513", "riemann-04", "riemann-", "riemann-4x", "riemann", "tessellated--1",
        "riemann-0-unguarded", "riemann--unguarded", "riemann-4-unguarded-uncorrected", "tessellated-5-unguarded"})
    EXPECT_FALSE(all.find("quad.mean_value", bad)) << bad;
}

// Verification runs the standard members, which must be cheap; work-precision studies show how the scheme converges.
TEST(Families, HaveStandardMembersAndStudiedOnes) {
  int seen = 0;
  for (const EvaluationFamily* family : EvaluationRegister::instance().families("quad.mean_value")) {
    if (family->pattern != "riemann-<n>") continue;
    ++seen;
    EXPECT_EQ(family->standard, (std::vector<std::string>{"riemann-4", "riemann-7", "riemann-10"}));
    EXPECT_EQ(family->studied,
              (std::vector<std::string>{"riemann-2", "riemann-4", "riemann-10", "riemann-40", "riemann-160"}));
  }
  EXPECT_EQ(seen, 1);
}

TEST(Families, TakeDigitsFrom2To90) {
  const auto& all = EvaluationRegister::instance();
  for (const char* good : {"line-2", "line-90"}) EXPECT_TRUE(all.find("quad.mean_value", good)) << good;
  for (const char* bad : {"line-1", "line-91", "line-", "line"}) EXPECT_FALSE(all.find("quad.mean_value", bad)) << bad;
}

}  // namespace
}  // namespace cageproof::adaptive_qmvc::riemann_test
