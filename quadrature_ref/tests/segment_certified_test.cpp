// SPDX-License-Identifier: MIT
// Enclosures on segments contain numbers known by hand and the independent integrator's results, and no wrong number.
#include "certified_support.h"
#include "segment_support.h"

#include "certified/certified.h"

namespace cageproof::quadrature_ref {
namespace {

using Vec = Vec3<double>;

// All formulas except the one that another test adds, which has only a kernel.
std::vector<Formula> segment_formulas() {
  std::vector<Formula> rows;
  for (const Formula& formula : catalogue())
    if (formula.element == ElementKind::Segment && formula.source != "this test") rows.push_back(formula);
  return rows;
}

template <Scalar R = Mp100>
Result<R> enclosed(std::string_view formula, const Segment<double>& s, const Vec& point, int order,
                   const CertifiedEffort& effort = {}) {
  const Segment<R> corners{convert<R>(s[0]), convert<R>(s[1])};
  std::vector<R> parameters;
  for (const Parameter& p : formula_named(formula).parameters) parameters.emplace_back(p.preset);
  Result<R> result;
  integrate_certified(formula, Query<R>{corners, convert<R>(point), order, parameters}, result, effort);
  return result;
}

const Segment<double> kBelow{Vec(-1, -1, 0), Vec(1, -1, 0)};  // the origin is on its inner side, at distance one
const Segment<double> kUnit{Vec(0, 0, 0), Vec(1, 0, 0)};
const Vec kOrigin(0, 0, 0);

TEST(CertifiedSegment, values_by_hand) {
  const Mp100 half_turn = pi<Mp100>(), ln_2 = log(Mp100(2));
  const auto angle = enclosed("segment.winding_angle", kBelow, kOrigin, 0);
  EXPECT_TRUE(angle.converged);
  EXPECT_TRUE(holds(angle.value[0], angle.value_radius[0], half_turn / 2));
  EXPECT_FALSE(holds(angle.value[0], angle.value_radius[0], -half_turn / 2));

  const auto layers = enclosed("segment.double_layer", kBelow, kOrigin, 0);
  for (int k = 0; k < 2; ++k) EXPECT_TRUE(holds(layers.value[k], layers.value_radius[k], Mp100(1) / 8));

  // int ln(s^2 + 1)/2 from -1 to 1.
  const Mp100 logarithm = ln_2 - 2 + half_turn / 2;
  const auto single = enclosed("segment.single_layer", kBelow, kOrigin, 0);
  EXPECT_TRUE(holds(single.value[0], single.value_radius[0], -logarithm / (2 * half_turn)));
  const auto affine = enclosed("segment.affine_single_layer", kBelow, kOrigin, 0);
  for (int k = 0; k < 2; ++k) EXPECT_TRUE(holds(affine.value[k], affine.value_radius[k], -logarithm / (4 * half_turn)));
  const auto plate = enclosed("segment.biharmonic_double_layer", kBelow, kOrigin, 0);
  for (int k = 0; k < 2; ++k)
    EXPECT_TRUE(holds(plate.value[k], plate.value_radius[k], (logarithm - 1) / (8 * half_turn)));

  const auto weights = enclosed("segment.mean_value", kBelow, kOrigin, 0);  // int (s^2 + 1)^(-3/2) = sqrt(2)
  for (int k = 0; k < 2; ++k) EXPECT_TRUE(holds(weights.value[k], weights.value_radius[k], 1 / sqrt(Mp100(2))));
}

// int ln s = -1, int s ln s = -1/4, int s^2 (ln s - 1) = -4/9.
TEST(CertifiedSegment, weakly_singular_integrals_at_an_end) {
  const Mp100 half_turn = pi<Mp100>();
  const auto single = enclosed("segment.single_layer", kUnit, kOrigin, 0);
  EXPECT_TRUE(single.converged);
  EXPECT_TRUE(holds(single.value[0], single.value_radius[0], 1 / (2 * half_turn)));
  const auto affine = enclosed("segment.affine_single_layer", kUnit, kOrigin, 0);
  EXPECT_TRUE(holds(affine.value[1], affine.value_radius[1], 1 / (8 * half_turn)));
  const auto bi = enclosed("segment.biharmonic_single_layer", kUnit, kOrigin, 2);
  EXPECT_TRUE(bi.converged);
  EXPECT_TRUE(holds(bi.value[0], bi.value_radius[0], 1 / (18 * half_turn)));
  // Laplacian of the biharmonic potential: -G2 to -G1.
  EXPECT_TRUE(holds(bi.hessian[0] + bi.hessian[3], bi.hessian_radius[0] + bi.hessian_radius[3], 1 / (2 * half_turn)));
}

// Over its middle int ln |s| = -1 - ln 2.
TEST(CertifiedSegment, weakly_singular_integrals_within) {
  const auto single = enclosed("segment.single_layer", kUnit, Vec(0.5, 0, 0), 0);
  EXPECT_TRUE(holds(single.value[0], single.value_radius[0], Mp100(1 + log(Mp100(2))) / (2 * pi<Mp100>())));
}

TEST(CertifiedSegment, declines_where_nothing_converges) {
  for (const Vec& on : {Vec(0.5, 0, 0), Vec(0.25, 0, 0), kOrigin, Vec(1, 0, 0)}) {
    const auto jump = enclosed("segment.double_layer", kUnit, on, 1);
    EXPECT_FALSE(jump.converged);
    EXPECT_TRUE(isnan(jump.value[0]) && isinf(jump.value_radius[0]) && isnan(jump.gradient[0]));
    const auto single = enclosed("segment.single_layer", kUnit, on, 1);
    EXPECT_FALSE(single.converged);
    EXPECT_FALSE(isnan(single.value[0]));
    EXPECT_TRUE(isnan(single.gradient[0]) && isinf(single.gradient_radius[0]));
  }
  EXPECT_FALSE(enclosed("segment.single_layer", {kOrigin, kOrigin}, Vec(1, 0, 0), 0).converged);
  const Vec nowhere(0, std::numeric_limits<double>::quiet_NaN(), 0);
  EXPECT_FALSE(enclosed("segment.single_layer", kUnit, nowhere, 0).converged);
}

// On the line beyond the ends the heights are exactly zero, and so are the balls; their gradients are not.
TEST(CertifiedSegment, vanishing_tensors_are_exact_zeros) {
  for (const char* formula :
       {"segment.double_layer", "segment.mean_value", "segment.winding_angle", "segment.biharmonic_double_layer"}) {
    for (const double x : {3., -2.}) {
      const auto r = enclosed(formula, kUnit, Vec(x, 0, 0), 2);
      EXPECT_TRUE(r.converged) << formula;
      for (std::size_t i = 0; i < r.value.size(); ++i)
        EXPECT_TRUE(r.value[i] == 0 && r.value_radius[i] == 0) << formula;
      EXPECT_TRUE(r.gradient[1] != 0) << formula;
    }
  }
}

// Heights at the end of the exponents' range cancel thousands of bits beside the segment.
TEST(CertifiedSegment, reaches_the_ends_of_the_range) {
  const double denormal = std::numeric_limits<double>::denorm_min();
  for (const Formula& formula : segment_formulas())
    for (const Vec& point : {Vec(2, denormal, 0), Vec(0.5, denormal, 0), Vec(denormal, -denormal, 0),
                             Vec(1e300, -1e300, 0), Vec(-1e300, denormal, 0)}) {
      const auto r = enclosed<Mp200>(formula.name, kUnit, point, 2);
      EXPECT_TRUE(r.converged) << formula.name << " at " << point.transpose();
    }
  const auto angle = enclosed("segment.winding_angle", kUnit, Vec(2, denormal, 0), 0);  // height (1/1 - 1/2)
  EXPECT_LE(abs(Mp100(angle.value[0] - Mp100(denormal) / 2)), Mp100(denormal) * Mp100("1e-30"));
}

// Balls of two precisions share a point, and more bits narrow them.
TEST(CertifiedSegment, precisions_agree) {
  for (const Formula& formula : segment_formulas())
    for (const SegmentSample& sample : segment_samples()) {
      const auto coarse = enclosed<Mp200>(formula.name, sample.corners, sample.point, 2,
                                          {.first_bits = 128, .most_bits = 16, .bits_wanted = 10000});
      const auto fine = enclosed<Mp200>(formula.name, sample.corners, sample.point, 2);
      EXPECT_TRUE(fine.converged) << formula.name << ' ' << sample.regime;
      for (int o = 0; o <= 2; ++o)
        for (std::size_t i = 0; i < fine.of(o).size(); ++i) {
          const Mp200 &a = coarse.of(o)[i], &b = fine.of(o)[i];
          if (isnan(a)) continue;  // nothing known at 128 bits
          EXPECT_TRUE(abs(Mp200(a - b)) <= coarse.radius_of(o)[i] + fine.radius_of(o)[i])
              << formula.name << ' ' << sample.regime << ' ' << o << ' ' << i;
        }
    }
}

TEST(CertifiedSegment, independent_integrator_lies_inside_and_nothing_near_it) {
  std::size_t index = 0;
  const auto formulas = segment_formulas();
  for (const SegmentSample& sample : segment_samples())
    for (std::size_t f = index++ % 2; f < formulas.size(); f += 2) {
      const Formula& formula = formulas[f];
      const std::string what = std::string(formula.name) + ' ' + sample.regime + ' ' + std::to_string(index - 1);
      const auto ball = enclosed(formula.name, sample.corners, sample.point, 2);
      EXPECT_TRUE(ball.converged) << what;
      std::vector<Mp50> parameters;
      parameters.reserve(formula.parameters.size());
      for (const Parameter& p : formula.parameters) parameters.emplace_back(p.preset);
      const auto corners = corners_in<Mp50>(sample);
      Result<Mp50> integral;
      evaluation_named(formula.name, "multiprecision")(Query<Mp50>{corners, convert<Mp50>(sample.point), 2, parameters},
                                                       integral);
      if (!integral.converged) continue;
      for (int o = 0; o <= 2; ++o) {
        Mp100 norm = 0, widest = 0;
        for (const Mp50& x : integral.of(o)) norm = std::max(norm, Mp100(abs(x)));
        if (norm == 0) continue;
        const Mp100 slack = 10 * norm * pow(Mp100(10), Mp100(-integral.stated_digits));
        int outside_if_wrong = 0;
        for (std::size_t i = 0; i < ball.of(o).size(); ++i) {
          const Mp100 off = abs(Mp100(Mp100(integral.of(o)[i]) - ball.of(o)[i])), radius = ball.radius_of(o)[i];
          EXPECT_TRUE(off <= radius + slack) << what << ' ' << o << ' ' << i;
          widest = std::max(widest, radius);
          outside_if_wrong += abs(Mp100(ball.of(o)[i] + Mp100(integral.of(o)[i]))) > radius + slack;
        }
        EXPECT_TRUE(widest <= Mp100("1e-29") * norm) << what << ' ' << o;
        EXPECT_GT(outside_if_wrong, 0) << "the wrong sign lies inside: " << what << ' ' << o;
      }
    }
}

TEST(CertifiedSegment, every_segment_formula_lists_it_and_no_campaign_runs_it) {
  for (const Formula& formula : segment_formulas()) {
    ASSERT_TRUE(EvaluationRegister::instance().find(formula.name, "certified")) << formula.name;
    for (const std::string& name : EvaluationRegister::instance().standard(formula.name)) EXPECT_NE(name, "certified");
  }
}

}  // namespace
}  // namespace cageproof::quadrature_ref
