// SPDX-License-Identifier: MIT
// Enclosures: numbers known by hand lie in them, so does the independent integrator's result, and nothing wrong does.
#include "certified_support.h"
#include "support.h"

#include "certified/certified.h"

namespace cageproof::quadrature_ref {
namespace {

const std::vector<Mp100> kElastic{Mp100(1), Mp100(1) / 4};

std::vector<Mp100> parameters_of(const std::string& formula) {
  return formula.find("kelvin") == std::string::npos ? std::vector<Mp100>{} : kElastic;
}

template <Scalar R = Mp100>
Result<R> enclosed(const std::string& formula, const Triangle<double>& t, const Vec3<double>& point, int order,
                   const CertifiedEffort& effort = {}, std::optional<double> nu = std::nullopt) {
  const Triangle<R> corners{convert<R>(t[0]), convert<R>(t[1]), convert<R>(t[2])};
  std::vector<R> parameters;
  for (const Mp100& p : parameters_of(formula)) parameters.push_back(static_cast<R>(p));
  if (nu) parameters[1] = static_cast<R>(*nu);
  Result<R> result;
  integrate_certified(formula, Query<R>{corners, convert<R>(point), order, parameters}, result, effort);
  return result;
}

Mp100 sum(const std::vector<Mp100>& v) {
  Mp100 total = 0;
  for (const Mp100& x : v) total += x;
  return total;
}

std::vector<Formula> triangle_formulas() {
  std::vector<Formula> rows;
  for (const Formula& formula : catalogue())
    if (formula.element == ElementKind::Triangle) rows.push_back(formula);
  return rows;
}

// The eighth of a square of side 2 at distance 1 from the origin.
const Triangle<double> kEighth{Vec3<double>(0, 0, 1), Vec3<double>(1, 0, 1), Vec3<double>(1, 1, 1)};
const Vec3<double> kOrigin(0, 0, 0), kFoot(0, 0, 1);

TEST(Certified, solid_angle_of_an_octant) {
  const Triangle<double> octant{Vec3<double>(1, 0, 0), Vec3<double>(0, 1, 0), Vec3<double>(0, 0, 1)};
  const auto r = enclosed("triangle.solid_angle", octant, kOrigin, 0);
  EXPECT_TRUE(r.converged);
  EXPECT_TRUE(holds(r.value[0], r.value_radius[0], pi<Mp100>() / 2));
  EXPECT_FALSE(holds(r.value[0], r.value_radius[0], -pi<Mp100>() / 2));
}

// In polar coordinates about the foot of the origin, rho up to sec theta, theta up to pi/4.
TEST(Certified, values_by_hand) {
  const Mp100 eighth = asinh(Mp100(1 / sqrt(Mp100(2)))) - pi<Mp100>() / 12;  // int 1/r
  const auto single = enclosed("triangle.single_layer", kEighth, kOrigin, 0);
  EXPECT_TRUE(holds(single.value[0], single.value_radius[0], eighth / (4 * pi<Mp100>())));

  const auto affine = enclosed("triangle.affine_single_layer", kEighth, kOrigin, 0);
  EXPECT_TRUE(holds(sum(affine.value), sum(affine.value_radius), eighth / (4 * pi<Mp100>())));

  const auto angle = enclosed("triangle.solid_angle", kEighth, kOrigin, 0);  // an eighth of a cube's face
  EXPECT_TRUE(holds(angle.value[0], angle.value_radius[0], pi<Mp100>() / 12));

  const auto layers = enclosed("triangle.double_layer", kEighth, kOrigin, 0);
  EXPECT_TRUE(holds(sum(layers.value), sum(layers.value_radius), Mp100(1) / 48));

  const auto plate = enclosed("triangle.biharmonic_double_layer", kEighth, kOrigin, 0);  // -(int 1/r)/(8 pi)
  EXPECT_TRUE(holds(sum(plate.value), sum(plate.value_radius), -eighth / (8 * pi<Mp100>())));

  const Mp100 root = 1 / sqrt(Mp100(2));
  const auto mean = enclosed("triangle.mean_value", kEighth, kOrigin, 0);  // int 1/(rho^2 + 1)^2
  EXPECT_TRUE(holds(sum(mean.value), sum(mean.value_radius), root / 2 * atan(root)));

  // Traces, with a = 1/(4 pi) and b = a/3: (3a - 2b) int 1/r, and mu 3a times the solid angle.
  const auto trace = [](const std::vector<Mp100>& v) {
    Mp100 total = 0;
    for (std::size_t i = 0; i < v.size(); ++i)
      if (i % 9 % 4 == 0) total += v[i];
    return total;
  };
  const auto kelvin = enclosed("triangle.kelvin_displacement", kEighth, kOrigin, 0);
  EXPECT_TRUE(holds(trace(kelvin.value), trace(kelvin.value_radius), 7 * eighth / (12 * pi<Mp100>())));
  const auto traction = enclosed("triangle.kelvin_traction", kEighth, kOrigin, 0);
  EXPECT_TRUE(holds(trace(traction.value), trace(traction.value_radius), Mp100(1) / 16));
}

TEST(Certified, weakly_singular_integrals_at_a_corner) {
  const Mp100 logarithm = log(Mp100(1 + sqrt(Mp100(2))));
  const auto single = enclosed("triangle.single_layer", kEighth, kFoot, 0);  // int sec
  EXPECT_TRUE(single.converged);
  EXPECT_TRUE(holds(single.value[0], single.value_radius[0], logarithm / (4 * pi<Mp100>())));
  const auto bi = enclosed("triangle.biharmonic_single_layer", kEighth, kFoot, 2);  // int sec^3 / 3
  EXPECT_TRUE(bi.converged);
  EXPECT_TRUE(holds(bi.value[0], bi.value_radius[0], (sqrt(Mp100(2)) + logarithm) / (48 * pi<Mp100>())));
  // Laplacian of the biharmonic potential: -G2 to -G1.
  const Mp100 trace = bi.hessian[0] + bi.hessian[4] + bi.hessian[8];
  EXPECT_TRUE(holds(trace, 3 * bi.hessian_radius[0], logarithm / (4 * pi<Mp100>())));
}

TEST(Certified, declines_where_nothing_converges) {
  const auto on_face = Vec3<double>(.5, .25, 1);
  const auto jump = enclosed("triangle.double_layer", kEighth, on_face, 1);
  EXPECT_FALSE(jump.converged);
  EXPECT_TRUE(isnan(jump.value[0]) && isinf(jump.value_radius[0]) && isnan(jump.gradient[0]));
  const auto single = enclosed("triangle.single_layer", kEighth, on_face, 1);
  EXPECT_FALSE(single.converged);
  EXPECT_FALSE(isnan(single.value[0]));
  EXPECT_TRUE(isnan(single.gradient[0]) && isinf(single.gradient_radius[0]));
  const Vec3<double> p(0, 0, 0), q(1, 1, 1), line(2, 2, 2);
  EXPECT_FALSE(enclosed("triangle.single_layer", {p, q, line}, kFoot, 0).converged);
  const Vec3<double> nowhere(0, 0, std::numeric_limits<double>::quiet_NaN());
  EXPECT_FALSE(enclosed("triangle.single_layer", kEighth, nowhere, 0).converged);
}

// Exact sums of such numbers have as many bits as their exponents are apart.
TEST(Certified, declines_numbers_too_far_apart) {
  const Triangle<Mp200> far{convert<Mp200>(kEighth[0]), convert<Mp200>(kEighth[1]),
                            Vec3<Mp200>(Mp200(1), ldexp(Mp200(1), 30000), Mp200(1))};
  const Triangle<Mp200> close{convert<Mp200>(kEighth[0]), convert<Mp200>(kEighth[1]),
                              Vec3<Mp200>(Mp200(1), Mp200(1), ldexp(Mp200(1), -30000))};
  for (const auto& corners : {far, close}) {
    Result<Mp200> r;
    integrate_certified("triangle.single_layer", Query<Mp200>{corners, convert<Mp200>(kOrigin), 0}, r);
    EXPECT_FALSE(r.converged);
    EXPECT_TRUE(isnan(r.value[0]) && isinf(r.value_radius[0]));
  }
}

// At nu = 1/2 the traction's kernel vanishes in the plane, and so, exactly, does the ball; its gradient does not.
TEST(Certified, vanishing_tensors_are_exact_zeros) {
  const Vec3<double> beside(3, 0, 1);
  for (const auto& [formula, nu] :
       std::vector<std::pair<std::string, std::optional<double>>>{{"triangle.kelvin_traction", .5},
                                                                  {"triangle.double_layer", std::nullopt},
                                                                  {"triangle.mean_value", std::nullopt}}) {
    const auto r = enclosed(formula, kEighth, beside, 2, {}, nu);
    EXPECT_TRUE(r.converged) << formula;
    for (std::size_t i = 0; i < r.value.size(); ++i) EXPECT_TRUE(r.value[i] == 0 && r.value_radius[i] == 0) << formula;
    EXPECT_TRUE(sum(r.gradient_radius) > 0) << formula;
  }
}

// b = 0 in the limit nu to infinity: K = a/r I.
TEST(Certified, infinite_poisson_ratio) {
  const double infinity = std::numeric_limits<double>::infinity();
  const auto r = enclosed("triangle.kelvin_displacement", kEighth, kOrigin, 0, {}, infinity);
  const auto single = enclosed("triangle.single_layer", kEighth, kOrigin, 0);
  EXPECT_TRUE(holds(r.value[4], r.value_radius[4] + single.value_radius[0], single.value[0]));
  EXPECT_TRUE(holds(r.value[1], r.value_radius[1], Mp100(0)));
}

// Balls of two precisions share a point, and more bits narrow them.
TEST(Certified, precisions_agree) {
  int index = 0;
  for (const Sample& sample : regime_samples(5)) {
    const std::string formula = index++ % 3 == 0 ? "triangle.mean_value" : "triangle.double_layer";
    const auto coarse =
        enclosed<Mp200>(formula, sample.corners, sample.point, 2, {.first_bits = 128, .most_bits = 128});
    const auto fine = enclosed<Mp200>(formula, sample.corners, sample.point, 2, {.first_bits = 512, .most_bits = 512});
    EXPECT_TRUE(fine.converged) << formula << ' ' << sample.regime;
    for (int o = 0; o <= 2; ++o)
      for (std::size_t i = 0; i < fine.of(o).size(); ++i) {
        const Mp200 &a = coarse.of(o)[i], &b = fine.of(o)[i], &ra = coarse.radius_of(o)[i], &rb = fine.radius_of(o)[i];
        if (isnan(a)) continue;  // nothing known at 128 bits
        EXPECT_TRUE(abs(Mp200(a - b)) <= ra + rb && rb <= ra)
            << formula << ' ' << sample.regime << ' ' << o << ' ' << i;
      }
  }
}

TEST(Certified, independent_integrator_lies_inside_and_nothing_near_it) {
  int index = 0;
  for (const Sample& sample : regime_samples(7)) {
    const auto formulas = triangle_formulas();
    const std::string formula(formulas[index++ % formulas.size()].name);
    const auto ball = enclosed(formula, sample.corners, sample.point, 2);
    EXPECT_TRUE(ball.converged) << formula << ' ' << sample.regime;
    const auto& c = sample.corners;
    const Triangle<Mp50> corners{convert<Mp50>(c[0]), convert<Mp50>(c[1]), convert<Mp50>(c[2])};
    std::vector<Mp50> parameters;
    for (const Mp100& p : parameters_of(formula)) parameters.emplace_back(p);
    Result<Mp50> integral;
    (*EvaluationRegister::instance().find(formula, "multiprecision"))(
        {corners, convert<Mp50>(sample.point), 2, parameters}, integral);
    for (int o = 0; o <= 2; ++o) {
      Mp100 norm = 0, widest = 0;
      for (const Mp50& x : integral.of(o)) norm = std::max(norm, Mp100(abs(x)));
      const Mp100 slack = 10 * norm * pow(Mp100(10), Mp100(-integral.stated_digits));
      int outside_if_wrong = 0;
      for (std::size_t i = 0; i < ball.of(o).size(); ++i) {
        const Mp100 off = abs(Mp100(Mp100(integral.of(o)[i]) - ball.of(o)[i])), radius = ball.radius_of(o)[i];
        EXPECT_TRUE(off <= radius + slack) << formula << ' ' << sample.regime << ' ' << o << ' ' << i;
        widest = std::max(widest, radius);
        outside_if_wrong += abs(Mp100(ball.of(o)[i] + Mp100(integral.of(o)[i]))) > radius + slack;
      }
      EXPECT_TRUE(widest <= Mp100("1e-29") * norm) << formula << ' ' << sample.regime << ' ' << o;
      EXPECT_GT(outside_if_wrong, 0) << "the wrong sign lies inside: " << formula << ' ' << sample.regime << ' ' << o;
    }
  }
}

TEST(Certified, orders_asked_alone_are_the_same) {
  const Vec3<double> point(.3, -.2, .4);
  for (const Formula& formula : triangle_formulas()) {
    const std::string name(formula.name);
    const auto all = enclosed(name, kEighth, point, 2);
    for (int order = 0; order <= 1; ++order) {
      const auto some = enclosed(name, kEighth, point, order);
      EXPECT_TRUE(some.of(order + 1).empty() && some.radius_of(order + 1).empty()) << name;
      for (std::size_t i = 0; i < some.of(order).size(); ++i)
        EXPECT_TRUE(abs(Mp100(some.of(order)[i] - all.of(order)[i])) <=
                    some.radius_of(order)[i] + all.radius_of(order)[i]);
    }
  }
}

TEST(Certified, radii_hold_the_rounding_of_the_midpoint) {
  const Vec3<double> point(.25, .125, .5);  // exact in float
  const auto exact = enclosed("triangle.kelvin_traction", kEighth, point, 1);
  const auto narrow = enclosed<float>("triangle.kelvin_traction", kEighth, point, 1);
  const auto wide = enclosed<double>("triangle.kelvin_traction", kEighth, point, 1);
  EXPECT_TRUE(narrow.converged && wide.converged);
  for (int o = 0; o <= 1; ++o)
    for (std::size_t i = 0; i < exact.of(o).size(); ++i) {
      EXPECT_TRUE(abs(Mp100(exact.of(o)[i] - wide.of(o)[i])) <= wide.radius_of(o)[i]);
      EXPECT_TRUE(abs(Mp100(exact.of(o)[i] - narrow.of(o)[i])) <= narrow.radius_of(o)[i]);
      EXPECT_LE(wide.radius_of(o)[i], 1.2e-16 * std::abs(wide.of(o)[i]) + 1e-30);
      EXPECT_LE(narrow.radius_of(o)[i], 6.1e-8f * std::abs(narrow.of(o)[i]) + 1e-30f);
    }
}

TEST(Certified, every_triangle_formula_lists_it_and_no_campaign_runs_it) {
  for (const Formula& formula : triangle_formulas()) {
    ASSERT_TRUE(EvaluationRegister::instance().find(formula.name, "certified")) << formula.name;
    for (const std::string& name : EvaluationRegister::instance().standard(formula.name)) EXPECT_NE(name, "certified");
  }
}

}  // namespace
}  // namespace cageproof::quadrature_ref
