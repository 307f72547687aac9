// SPDX-License-Identifier: MIT
// The fixed rules: names, exactness, symmetry, and kernels against finite differences.
#include "rules/triangle/triangle_rules.h"
#include "support.h"

#include <numbers>

namespace cageproof::quadrature_ref {
namespace {

/// hat_0^p hat_1^q: what a rule of enough points integrates exactly.
class Monomial final : public Kernel<double> {
 public:
  Monomial(int p, int q) : p_(p), q_(q) {}
  void accumulate(std::span<const Node<double>> nodes, const KernelTask<double>&, Result<double>& sums) const override {
    for (const auto& node : nodes) sums.value[0] += node.weight * std::pow(node.hat[0], p_) * std::pow(node.hat[1], q_);
  }

 private:
  int p_, q_;
};

const Triangle<double> kTriangle{Vec3<double>(0, 0, 0), Vec3<double>(2, 0, 0), Vec3<double>(0, 0, 3)};

Formula area_formula() {
  Formula formula = *find_formula("triangle.single_layer");
  formula.degree = 2;
  return formula;
}

// A fixed rule at one point.
template <class Rule>
Result<double> at_point(Rule rule, const Integrand& integrand, int n, const Query<double>& query) {
  Result<double> result;
  integrand.reset(result, query.order);
  Statement statement;
  rule(integrand, n, Batch<double>{query.corners, {&query.point, 1}, query.order},
       output_of(integrand.formula, result, statement));
  result.nodes = statement.nodes;
  return result;
}

// The exact integral: 2 area p! q! / (p + q + 2)!.
double exact(int p, int q) { return 6 * std::tgamma(p + 1) * std::tgamma(q + 1) / std::tgamma(p + q + 3); }

TEST(Gauss, polynomial_exactness) {
  const Formula formula = area_formula();
  const Query<double> query{kTriangle, Vec3<double>(1, 1, 1)};
  for (int n = 1; n <= 6; ++n)
    for (int p = 0; p <= 2 * n - 2; ++p) {
      const int q = 2 * n - 2 - p;
      KernelSet kernels;
      kernels.set<double>(3, std::make_unique<Monomial>(p, q));
      auto result = at_point(triangle::integrate_gauss<double>, {formula, kernels, formula.degree}, n, query);
      EXPECT_NEAR(result.value[0] / exact(p, q), 1, 1e-14) << n << ' ' << p;
      EXPECT_EQ(result.nodes, std::size_t(n) * n);
      result = at_point(triangle::integrate_three_quads<double>, {formula, kernels, formula.degree}, n, query);
      EXPECT_NEAR(result.value[0] / exact(p, q), 1, 1e-14) << n << ' ' << p;
      EXPECT_EQ(result.nodes, std::size_t(n) * n * 3);
    }
}

TEST(Gauss, polynomials_beyond_are_not_exact) {
  const Formula formula = area_formula();
  const Query<double> query{kTriangle, Vec3<double>(1, 1, 1)};
  KernelSet kernels;
  kernels.set<double>(3, std::make_unique<Monomial>(6, 0));
  auto result = at_point(triangle::integrate_gauss<double>, {formula, kernels, formula.degree}, 3, query);
  EXPECT_GT(std::abs(result.value[0] / exact(6, 0) - 1), 1e-6);
  result = at_point(triangle::integrate_three_quads<double>, {formula, kernels, formula.degree}, 3, query);
  EXPECT_GT(std::abs(result.value[0] / exact(6, 0) - 1), 1e-6);
}

// On the triangle the double layer is half a hat function, as it is just inside.
TEST(NearSingular, has_the_limit_from_inside_on_the_triangle) {
  const Triangle<double> t{Vec3<double>(0, 0, 0), Vec3<double>(4, 0, 0), Vec3<double>(0, 4, 0)};
  const auto found = evaluate<double>("triangle.double_layer", "near-singular-16", t, Vec3<double>(1, 1.5, 0), 0);
  EXPECT_NEAR(found.value[0], .1875, 1e-8);
  EXPECT_NEAR(found.value[1], .125, 1e-8);
  EXPECT_NEAR(found.value[2], .1875, 1e-8);
  const auto angle = evaluate<double>("triangle.solid_angle", "near-singular-16", t, Vec3<double>(2, 2, 0), 0);
  EXPECT_NEAR(angle.value[0], std::numbers::pi, 1e-8) << "on an edge: half of that within";
}

TEST(Gauss, names_of_the_families) {
  const auto exists = [](const char* formula, const char* name) {
    return EvaluationRegister::instance().find(formula, name).has_value();
  };
  for (const char* name : {"gauss-1", "gauss-256", "three-quad-3", "three-quad-75", "three-quad-300", "three-quad-1200",
                           "three-quad-7500", "near-singular-2", "near-singular-64", "adaptive", "multiprecision"})
    EXPECT_TRUE(exists("triangle.double_layer", name)) << name;
  for (const char* name : {"gauss-", "gauss-0", "gauss-257", "gauss--4", "gauss-08", "gauss-4x", "gauss-99999999999",
                           "three-quad-76", "three-quad-4", "near-singular-1", "near-singular-65", "adaptive-2", ""})
    EXPECT_FALSE(exists("triangle.double_layer", name)) << name;
  for (const char* name : {"gauss-1", "gauss-256", "adaptive", "multiprecision"})
    EXPECT_TRUE(exists("quad.mean_value", name)) << name;
  for (const char* name : {"gauss-0", "gauss-257", "near-singular-16"})
    EXPECT_FALSE(exists("quad.mean_value", name)) << name;
  for (const char* name : {"gauss-1", "gauss-256", "near-singular-2", "near-singular-64", "adaptive", "multiprecision"})
    EXPECT_TRUE(exists("segment.single_layer", name)) << name;
  for (const char* name : {"gauss-0", "gauss-257", "near-singular-1", "near-singular-65", "three-quad-3"})
    EXPECT_FALSE(exists("segment.single_layer", name)) << name;
  for (const std::string& formula : kFormulas)
    for (const std::string& name : EvaluationRegister::instance().standard(formula))
      EXPECT_TRUE(EvaluationRegister::instance().find(formula, name)) << formula << ' ' << name;
}

// One node: the rule's value is the kernel at it times a constant, so its differences in eta are the kernel's
// derivatives.
TEST(Kernel, derivatives_against_differences) {
  const Triangle<Mp50> t{Vec3<Mp50>(0, 0, 0), Vec3<Mp50>(2, 1, 0), Vec3<Mp50>(0, 1, 2)};
  const Vec3<Mp50> eta(Mp50(1) / 3, Mp50(-2) / 7, Mp50(5) / 11);
  const std::array<Mp50, 4> weights{Mp50(4) / 5, Mp50(-1) / 5, Mp50(4) / 105, Mp50(-1) / 280};
  const Mp50 h = Mp50(1) / 10000;
  for (const std::string& formula : kFormulas) {
    const auto at = [&](const Vec3<Mp50>& point) { return evaluate<Mp50>(formula, "gauss-1", t, point, 2); };
    const Result<Mp50> exact = at(eta);
    const std::size_t components = exact.value.size();
    std::vector<Mp50> gradient(components * 3, Mp50(0)), hessian(components * 9, Mp50(0));
    for (int j = 0; j < 3; ++j)
      for (int k = 1; k <= 4; ++k)
        for (const int side : {-1, 1}) {
          Vec3<Mp50> shifted = eta;
          shifted[j] += side * k * h;
          const Result<Mp50> r = at(shifted);
          const Mp50 weight = side * weights[k - 1] / h;
          for (std::size_t c = 0; c < components; ++c) {
            gradient[3 * c + j] += weight * r.value[c];
            for (int i = 0; i < 3; ++i) hessian[9 * c + 3 * i + j] += weight * r.gradient[3 * c + i];
          }
        }
    EXPECT_LT(log10_error(gradient, exact.gradient), -27) << formula;
    EXPECT_LT(log10_error(hessian, exact.hessian), -27) << formula;
  }
}

TEST(Gauss, bad_geometry_gives_nan) {
  const Triangle<double> flat{Vec3<double>(0, 0, 0), Vec3<double>(1, 1, 1), Vec3<double>(2, 2, 2)};
  const double infinity = std::numeric_limits<double>::infinity();
  for (const std::string name : {"gauss-4", "three-quad-75", "near-singular-8", "adaptive", "multiprecision"}) {
    EXPECT_TRUE(
        std::isnan(evaluate<double>("triangle.single_layer", name, flat, Vec3<double>(1, 0, 0), 1).gradient[2]));
    const auto r = evaluate<double>("triangle.single_layer", name, kTriangle, Vec3<double>(infinity, 0, 0), 0);
    EXPECT_TRUE(std::isnan(r.value[0])) << name;
    EXPECT_FALSE(r.converged) << name;
  }
}

// Rules work in the triangle's own unit, so units of length near the ends of double's range do not matter.
TEST(Gauss, scaling) {
  for (const std::string& formula : kFormulas) {
    const int degree = find_formula(formula)->degree;
    const auto reference = evaluate<double>(formula, "gauss-8", kTriangle, Vec3<double>(1, 2, 1), 1);
    for (const int exponent : {-100, 100}) {
      const double unit = std::ldexp(1.0, exponent);
      const Triangle<double> t{unit * kTriangle[0], unit * kTriangle[1], unit * kTriangle[2]};
      const auto scaled = evaluate<double>(formula, "gauss-8", t, Vec3<double>(unit, 2 * unit, unit), 1);
      EXPECT_EQ(scaled.value[0], std::ldexp(reference.value[0], exponent * degree)) << formula;
      EXPECT_EQ(scaled.gradient[1], std::ldexp(reference.gradient[1], exponent * (degree - 1))) << formula;
    }
  }
}

}  // namespace
}  // namespace cageproof::quadrature_ref
