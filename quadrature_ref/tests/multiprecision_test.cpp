// SPDX-License-Identifier: MIT
// The reference integral: the digits it states, in every regime, and its limits on the triangle.
#include "support.h"

namespace cageproof::quadrature_ref {
namespace {

const Triangle<double> kTriangle{Vec3<double>(0, 0, 0), Vec3<double>(4, 0, 0), Vec3<double>(0, 3, 0)};

// The integral at 60 digits has other panels, other points and twice the precision.
TEST(Multiprecision, stands_behind_its_digits) {
  int index = 0;
  std::vector<Sample> samples = regime_samples(1);
  // The one of 500 random samples where both rules once stopped at the same 31.6 digits: a branch point of the radial
  // variable had been overlooked.
  samples.insert(samples.begin(), {"line",
                                   {Vec3<double>(0.18647210538458214, 0.056807263042774503, -0.52204728739958628),
                                    Vec3<double>(0.84190747579024827, -0.0068117759840962133, -0.00021801194485870923),
                                    Vec3<double>(0.23495315343381609, 0.052101269460990134, -0.48344831314582237)},
                                   {0.11245372071986437, 0.063991763099329468, -0.58097751407789544}});
  for (const Sample& sample : samples) {
    const std::string& formula = kFormulas[index++ % kFormulas.size()];
    const auto result = evaluate<Mp50>(formula, "multiprecision", sample, 2);
    const auto truth = evaluate<Mp100>(formula, "multiprecision", sample, 2);
    EXPECT_TRUE(result.converged) << formula << ' ' << sample.regime << ' ' << result.stated_digits;
    EXPECT_GE(truth.stated_digits, 58) << formula << ' ' << sample.regime;
    for (int order = 0; order <= 2; ++order)
      EXPECT_LT(log10_error(result.of(order), truth.of(order)), -result.stated_digits)
          << formula << ' ' << sample.regime << ' ' << order;
  }
}

TEST(Multiprecision, float_and_double_are_the_rounded_integral) {
  const Sample sample{"", kTriangle, {1, 1.5, -1e-3}};
  const auto wide = evaluate<Mp50>("triangle.double_layer", "multiprecision", sample, 1);
  const auto narrow = evaluate<double>("triangle.double_layer", "multiprecision", sample, 1);
  for (int k = 0; k < 3; ++k) EXPECT_EQ(narrow.value[k], static_cast<double>(wide.value[k]));
  const auto single = evaluate<float>("triangle.double_layer", "multiprecision", sample, 0);
  EXPECT_NEAR(single.value[1], static_cast<double>(wide.value[1]), 1e-7);
}

// A result's statement contains its cost.
TEST(Multiprecision, counts_its_nodes) {
  const Sample near{"", kTriangle, {1.25, .75, 1e-9}};
  for (const std::string& formula : kFormulas) {
    const auto narrow = evaluate<Mp50>(formula, "multiprecision", near, 0);
    const auto wide = evaluate<Mp100>(formula, "multiprecision", near, 0);
    EXPECT_GT(narrow.nodes, 100U) << formula;
    EXPECT_GT(wide.nodes, narrow.nodes) << formula;
  }
}

// The triangle cut into four: integrals are additive, whatever the position of eta to the parts.
TEST(Multiprecision, subdivision) {
  const Sample whole{"", kTriangle, {1.25, .75, 1e-9}};
  const auto& [a, b, c] = whole.corners;
  const Vec3<double> ab = (a + b) / 2, bc = (b + c) / 2, ca = (c + a) / 2;
  const std::array<Triangle<double>, 4> parts{Triangle<double>{a, ab, ca}, Triangle<double>{ab, b, bc},
                                              Triangle<double>{ca, bc, c}, Triangle<double>{bc, ca, ab}};
  const auto total = evaluate<Mp50>("triangle.single_layer", "multiprecision", whole, 2);
  Result<Mp50> sum;
  sum.reset(1, 3, 2);
  for (const Triangle<double>& part : parts) {
    const auto r = evaluate<Mp50>("triangle.single_layer", "multiprecision", Sample{"", part, whole.point}, 2);
    for (int order = 0; order <= 2; ++order)
      for (std::size_t i = 0; i < r.of(order).size(); ++i) sum.of(order)[i] += r.of(order)[i];
  }
  // Hessians of parts that end below eta are 1e9 larger than their sum.
  for (int order = 0; order <= 2; ++order)
    EXPECT_LT(log10_error(sum.of(order), total.of(order)), order == 2 ? -21 : -29);
}

const std::array<Vec3<double>, 4> kTetrahedron{Vec3<double>(0, 0, 0), Vec3<double>(1, 0, 0), Vec3<double>(0, 1, 0),
                                               Vec3<double>(0, 0, 1)};
constexpr std::array<std::array<int, 3>, 4> kFaces{{{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}};

// Sum over the closed surface of the double layers' values at a point.
Mp50 closed_sum(const std::string& formula, const Vec3<double>& point) {
  Mp50 sum = 0;
  for (const auto& f : kFaces) {
    const Sample face{"", {kTetrahedron[f[0]], kTetrahedron[f[1]], kTetrahedron[f[2]]}, point};
    for (const Mp50& x : evaluate<Mp50>(formula, "multiprecision", face, 0).value) sum += x;
  }
  return sum;
}

TEST(Multiprecision, closed_surface) {
  const Vec3<double> inside(.3, .2, .1), outside(.5, .5, .2), close(.3, .3, 1e-12);
  for (const Vec3<double>& point : {inside, close}) {
    EXPECT_LT(log10_of(Mp50(abs(closed_sum("triangle.solid_angle", point) - 4 * pi<Mp50>()))), -29);
    EXPECT_LT(log10_of(Mp50(abs(closed_sum("triangle.double_layer", point) - 1))), -29);
  }
  EXPECT_LT(log10_of(Mp50(abs(closed_sum("triangle.double_layer", outside)))), -29);
}

TEST(Multiprecision, double_layer_on_the_triangle_is_half_the_hat_function) {
  const Vec3<double> point(1, .75, 0);
  const std::array<Mp50, 3> hat{Mp50(1) / 2, Mp50(1) / 4, Mp50(1) / 4};
  const auto r = evaluate<Mp50>("triangle.double_layer", "multiprecision", Sample{"", kTriangle, point}, 0);
  for (int k = 0; k < 3; ++k) EXPECT_LT(log10_of(Mp50(abs(r.value[k] - hat[k] / 2))), -30);
  EXPECT_GE(r.stated_digits, 30);
}

TEST(Multiprecision, limits_on_the_triangle) {
  const auto at = [](const char* formula, double x, double y, int order) {
    return evaluate<Mp50>(formula, "multiprecision", Sample{"", kTriangle, {x, y, 0}}, order);
  };
  // In the face everything but the mean value weight has its limit.
  for (const char* formula : {"triangle.single_layer", "triangle.biharmonic_single_layer"}) {
    const auto r = at(formula, 1, 1, 2);
    EXPECT_TRUE(r.converged) << r.stated_digits;
    for (int order = 0; order <= 2; ++order) EXPECT_FALSE(isnan(r.of(order)[0])) << formula << order;
  }
  EXPECT_EQ(at("triangle.biharmonic_double_layer", 1, 1, 0).value[0], 0);
  const auto weight = at("triangle.mean_value", 1, 1, 1);
  EXPECT_TRUE(isnan(weight.value[0]) && isnan(weight.gradient[0]));
  EXPECT_FALSE(weight.converged);
  // On an edge and at a vertex only the single layer's value exists; its gradient grows like a logarithm.
  for (const double x : {1.0, 0.0, 4.0}) {
    const auto r = at("triangle.single_layer", x, 0, 1);
    EXPECT_TRUE(r.converged);
    EXPECT_FALSE(isnan(r.value[0]));
    EXPECT_TRUE(isnan(r.gradient[0]));
    // The nearest doubles off the triangle: what the limit must continue.
    const auto beside =
        evaluate<Mp50>("triangle.single_layer", "multiprecision", Sample{"", kTriangle, {x, 0, -1e-30}}, 0);
    EXPECT_LT(log10_error(r.value, beside.value), -27);
  }
  // The right angle at corner 0, seen from inside: a quarter of the half space.
  EXPECT_LT(log10_of(Mp50(abs(at("triangle.solid_angle", 0, 0, 0).value[0] - pi<Mp50>() / 2))), -30);
}

TEST(Multiprecision, in_the_plane_but_off_the_triangle_the_double_layer_vanishes) {
  for (const Vec3<double>& point : {Vec3<double>(3, 3, 0), Vec3<double>(5, 0, 0), Vec3<double>(1, -0x1p-52, 0)}) {
    const auto r = evaluate<Mp50>("triangle.double_layer", "multiprecision", Sample{"", kTriangle, point}, 1);
    for (const Mp50& x : r.value) EXPECT_EQ(x, 0);
    EXPECT_NE(r.gradient[2], 0);
    EXPECT_TRUE(r.converged);
  }
}

TEST(Multiprecision, jump_across_the_face) {
  const auto at = [](double z) {
    return evaluate<Mp50>("triangle.double_layer", "multiprecision", Sample{"", kTriangle, {1, .75, z}}, 0);
  };
  const auto inside = at(-1e-40), outside = at(1e-40);
  EXPECT_LT(log10_of(Mp50(abs(inside.value[0] - outside.value[0] - Mp50(1) / 2))), -30);
}

}  // namespace
}  // namespace cageproof::quadrature_ref
