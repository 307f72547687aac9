// SPDX-License-Identifier: MIT
// The adaptive rule keeps its word: where it says that it converged, it did.
#include "rules/triangle/triangle_rules.h"
#include "support.h"

namespace cageproof::quadrature_ref {
namespace {

template <Scalar R>
void expect_honest(const std::string& formula, const Sample& sample, int order, int& met) {
  const auto result = evaluate<R>(formula, "adaptive", sample, order);
  // float's geometry is the sample's rounded to float: so must be the truth's.
  const auto rounded = [](const Vec3<double>& x) { return convert<double>(convert<R>(x)); };
  const Sample seen{sample.regime,
                    {rounded(sample.corners[0]), rounded(sample.corners[1]), rounded(sample.corners[2])},
                    rounded(sample.point)};
  const auto truth = evaluate<Mp50>(formula, "multiprecision", seen, order);
  EXPECT_LE(result.nodes, kAdaptiveNodeLimit);
  EXPECT_GE(result.stated_digits, 0);
  const double tolerance = adaptive_tolerance<R>();
  EXPECT_TRUE(!result.converged || result.stated_digits >= -std::log10(2 * tolerance));
  met += result.converged;
  if (result.stated_digits == 0) return;
  for (int o = 0; o <= order; ++o)
    EXPECT_LE(log10_error(result.of(o), truth.of(o)), -result.stated_digits)
        << formula << ' ' << sample.regime << ' ' << o << " nodes " << result.nodes;
}

TEST(Adaptive, honest_in_double) {
  int met_values = 0, met_all = 0, index = 0;
  for (const Sample& sample : regime_samples(2)) {
    const std::string& formula = kFormulas[index++ % kFormulas.size()];
    expect_honest<double>(formula, sample, 0, met_values);
    expect_honest<double>(formula, sample, 2, met_all);
  }
  EXPECT_EQ(met_values, index) << "values are met in every regime";
  EXPECT_GE(met_all, index - 6) << "only Hessians next to the face are out of reach";
}

TEST(Adaptive, honest_in_float) {
  int met = 0, index = 0;
  for (const Sample& sample : regime_samples(4)) {
    // 1e100 is no float.
    if (sample.regime == "scaled-or-moved") continue;
    const Vec3<double> edge = sample.corners[1] - sample.corners[0], other = sample.corners[2] - sample.corners[0];
    // Thinner triangles lose their area when rounded to float.
    if (edge.cross(other).norm() < 1e-5) continue;
    expect_honest<float>(kFormulas[index++ % kFormulas.size()], sample, 1, met);
  }
  EXPECT_GE(met, index - 4);
}

TEST(Adaptive, declines_what_it_cannot_meet) {
  const Triangle<double> t{Vec3<double>(0, 0, 0), Vec3<double>(4, 0, 0), Vec3<double>(0, 3, 0)};
  const auto hessian = evaluate<double>("triangle.double_layer", "adaptive", t, Vec3<double>(1, 1, 1e-12), 2);
  EXPECT_FALSE(hessian.converged);
  EXPECT_EQ(hessian.stated_digits, 0);
  // On the triangle: values have their limit from inside; the single layer's gradient on an edge has none.
  const auto value = evaluate<double>("triangle.double_layer", "adaptive", t, Vec3<double>(1, .75, 0), 0);
  EXPECT_TRUE(value.converged);
  EXPECT_NEAR(value.value[0], .25, 1e-10);
  EXPECT_FALSE(evaluate<double>("triangle.single_layer", "adaptive", t, Vec3<double>(1, 0, 0), 1).converged);
  EXPECT_FALSE(evaluate<double>("triangle.mean_value", "adaptive", t, Vec3<double>(1, 1, 0), 0).converged);
}

TEST(Adaptive, multiprecision_scalars_meet_fifteen_digits) {
  const Sample sample{"", {Vec3<double>(0, 0, 0), Vec3<double>(2, 0, .5), Vec3<double>(.5, 2, 0)}, {.7, .6, .6}};
  int met = 0;
  expect_honest<Mp50>("triangle.single_layer", sample, 1, met);
  EXPECT_EQ(met, 1);
}

}  // namespace
}  // namespace cageproof::quadrature_ref
