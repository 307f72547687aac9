// SPDX-License-Identifier: MIT
// A check that cannot fail is a defect: each is shown an evaluation that is wrong in the way it looks for.
#include "cageproof/validation/check.h"
#include "cageproof/validation/promise.h"
#include "cageproof/validation/regime.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace cageproof::validation {
namespace {

// An evaluation plus a term that has no symmetry, no scaling and no harmonic partner, and whose gradient is not its
// gradient.
Evaluation broken(const Evaluation& good, double size) {
  Evaluation bad(good.formula().name, good.name(), good.facts());
  for (const ScalarKind kind : scalar_kinds)
    with_scalar(kind, [&]<Scalar R>() {
      if (!good.supports<R>()) return;
      bad.set_point<R>([good, size](const Query<R>& query, Result<R>& result) {
        good(query, result);
        const R x = query.point[0] + 2 * query.corners[0][1] + 3 * query.corners[1][2] + R(1) / 3;
        // Odd in the height's sign, so that the jump across a face is wrong too.
        const Vec3<R> a = query.corners[1] - query.corners[0], b = query.corners[2] - query.corners[0];
        const R height = a.cross(b).dot(Vec3<R>(query.point - query.corners[0]));
        const R term = R(size) * (x * x * x + (height < 0 ? R(1) : R(-1)) / 7);
        for (int o = 0; o <= query.order; ++o)
          for (std::size_t i = 0; i < result.of(o).size(); ++i)
            result.of(o)[i] += R(static_cast<int>(i % 5) + 1) * term;
        result.stated_digits = 10;
      });
    });
  return bad;
}

struct Setting {
  const Check* check;
  const Formula* formula;
  ScalarKind scalar;
  const Regime* regime;
};

std::array<Finding, 3> measured(const Setting& s, const Evaluation& evaluation, std::uint64_t index) {
  const Sample sample = make_sample(*s.formula, *s.regime, 1, index);
  const Truth truth = truth_from(truth_source(*s.formula), sample, 2);
  ResultsAtSample results(sample);
  return s.check->measure({*s.formula, evaluation, s.scalar, sample, 2, truth, results});
}

// The largest finding over a few samples, by order; -1 where nothing was measured.
std::array<double, 3> largest(const Setting& s, const Evaluation& evaluation) {
  std::array<double, 3> worst{-1, -1, -1};
  for (std::uint64_t i = 0; i < 4; ++i) {
    const auto findings = measured(s, evaluation, i);
    for (int o = 0; o < 3; ++o)
      if (findings[o].status == Finding::Status::Measured) worst[o] = std::max(worst[o], findings[o].error);
  }
  return worst;
}

class EveryCheck : public testing::TestWithParam<std::string> {};

TEST_P(EveryCheck, passes_what_is_right_and_fails_a_broken_one) {
  const Check* check = find_check(GetParam());
  const bool on_face = GetParam() == "face_jump" || GetParam() == "limit";
  const ScalarKind scalar = GetParam() == "gradient_by_differences" || GetParam() == "limit" ? ScalarKind::Digits200
                            : check->unit() == "relative" || GetParam() == "enclosure"       ? ScalarKind::Digits100
                                                                                             : ScalarKind::Double;
  const Setting setting{check, find_formula("triangle.double_layer"), scalar,
                        find_regime(on_face ? "on-face" : "generic")};
  const std::string name = GetParam() == "stated_error"   ? "adaptive"
                           : GetParam() == "relative"     ? "accurate"
                           : scalar == ScalarKind::Double ? "hybrid"
                                                          : "closed_form";
  const Evaluation good = evaluation_named(setting.formula->name, name), bad = broken(good, 1e-6);
  for (const Evaluation& evaluation : {good, bad})
    ASSERT_TRUE(check->applies(*setting.formula, evaluation, scalar, setting.regime->name))
        << "a campaign would not ask";
  const auto right = largest(setting, good), wrong = largest(setting, bad);
  bool any = false;
  for (int o = 0; o < 3; ++o) {
    const auto promise =
        promise_for({check->name(), setting.formula->name, good.name(), name_of(scalar), setting.regime->name, o});
    if (right[o] < 0) continue;
    any = true;
    ASSERT_TRUE(promise.bound) << "order " << o;
    EXPECT_LE(right[o], *promise.bound) << "order " << o;
    EXPECT_GT(wrong[o], *promise.bound) << "order " << o;
  }
  EXPECT_TRUE(any);
}

TEST(gradient_by_differences, fails_derivatives_that_are_zero_everywhere) {
  const Evaluation good = evaluation_named("triangle.double_layer", "closed_form");
  Evaluation flat(good.formula().name, good.name(), good.facts());
  flat.set_point<Mp200>([good](const Query<Mp200>& query, Result<Mp200>& result) {
    good(query, result);
    for (int o = 1; o <= query.order; ++o) std::ranges::fill(result.of(o), Mp200(0));
  });
  const Setting setting{find_check("gradient_by_differences"), find_formula("triangle.double_layer"),
                        ScalarKind::Digits200, find_regime("generic")};
  EXPECT_GT(largest(setting, flat)[1], 1e-3);
}

// Along one direction, which none of a tensor's entries is orthogonal to.
TEST(gradient_by_differences, sees_each_entry) {
  const Evaluation good = evaluation_named("triangle.double_layer", "closed_form");
  const Setting setting{find_check("gradient_by_differences"), find_formula("triangle.double_layer"),
                        ScalarKind::Digits200, find_regime("generic")};
  EXPECT_LT(largest(setting, good)[2], 1e-30);
  for (std::size_t entry = 0; entry < 9; ++entry) {
    Evaluation wrong(good.formula().name, good.name(), good.facts());
    wrong.set_point<Mp200>([good, entry](const Query<Mp200>& query, Result<Mp200>& result) {
      good(query, result);
      if (query.order == 2) result.hessian[entry] *= 1 + Mp200("1e-25");
    });
    EXPECT_GT(largest(setting, wrong)[2], 1e-28) << entry;
  }
}

std::vector<std::string> check_names() {
  std::vector<std::string> names;
  for (const auto& check : checks()) names.emplace_back(check->name());
  return names;
}

INSTANTIATE_TEST_SUITE_P(all, EveryCheck, testing::ValuesIn(check_names()), [](const auto& i) { return i.param; });

TEST(stated_error, is_asked_of_all_that_state_one) {
  const Check& check = *find_check("stated_error");
  for (const char* formula : {"triangle.double_layer", "quad.mean_value"})
    EXPECT_TRUE(
        check.applies(formula_named(formula), evaluation_named(formula, "adaptive"), ScalarKind::Double, "generic"))
        << formula;
  EXPECT_TRUE(check.applies(formula_named("triangle.double_layer"),
                            evaluation_named("triangle.double_layer", "accurate"), ScalarKind::Double, "generic"));
  EXPECT_FALSE(check.applies(formula_named("triangle.double_layer"),
                             evaluation_named("triangle.double_layer", "gauss-8"), ScalarKind::Double, "generic"));
}

// The Laplacian of biharmonic_single_layer by an evaluation whose name no formula but this one has.
TEST(laplacian, takes_the_partners_recommended_evaluation_where_it_has_none_of_that_name) {
  const Formula& formula = formula_named("triangle.biharmonic_single_layer");
  const Evaluation good = evaluation_named(formula.name, "hybrid");
  Evaluation named(formula.name, "name_of_its_own", good.facts());
  named.set_point<double>([good](const Query<double>& query, Result<double>& result) { good(query, result); });
  const Setting setting{find_check("laplacian"), &formula, ScalarKind::Double, find_regime("generic")};
  EXPECT_EQ(largest(setting, named), largest(setting, good));
  EXPECT_GT(largest(setting, named)[2], -1);
}

TEST(laplacian, is_unasked_where_nothing_computes_the_partner) {
  [[maybe_unused]] static const RegisterFormula row = [] {
    Formula formula = formula_named("triangle.biharmonic_single_layer");
    formula.name = "triangle.without_partner";
    formula.laplacian.formula = "triangle.of_no_catalogue";
    return RegisterFormula(formula);
  }();
  const Formula& formula = formula_named("triangle.without_partner");
  const Evaluation good = evaluation_named("triangle.biharmonic_single_layer", "closed_form");
  const Sample sample = make_sample(formula, *find_regime("generic"), 1, 0);
  const Truth truth = truth_from(truth_source(good.formula()), sample, 2);
  ResultsAtSample results(sample);
  const auto findings =
      find_check("laplacian")->measure({formula, good, ScalarKind::Double, sample, 2, truth, results});
  EXPECT_EQ(findings[2].status, Finding::Status::Unasked);
}

// A function that jumps by its basis functions across a bilinear quad and is smooth elsewhere: on the inner side the
// basis functions of the nearest point of the surface, on the outer side zero.
Evaluation quad_jump(double factor) {
  [[maybe_unused]] static const RegisterFormula row = [] {
    Formula formula = formula_named("quad.mean_value");
    formula.name = "quad.jump";
    formula.face_jump = {.number = 1};
    formula.degree = 0;
    return RegisterFormula(formula);
  }();
  Evaluation made("quad.jump", "closed_form", {.description = "for tests", .role = Role::Recommended, .max_order = 0});
  made.set_point<Mp100>([factor](const Query<Mp100>& query, Result<Mp100>& result) {
    result.reset(4, 3, 0);
    const auto& q = query.corners;
    // Newton's method for the parameters and the height of the point over the surface.
    Mp100 u = 0.5, v = 0.5, h = 0;
    for (int step = 0; step < 40; ++step) {
      const Vec3<Mp100> at = (1 - v) * ((1 - u) * q[0] + u * q[1]) + v * (u * q[2] + (1 - u) * q[3]);
      const Vec3<Mp100> a = (1 - v) * (q[1] - q[0]) + v * (q[2] - q[3]),
                        b = (1 - u) * (q[3] - q[0]) + u * (q[2] - q[1]);
      const Vec3<Mp100> n = a.cross(b), r = query.point - at;
      const Mp100 whole = n.dot(n);
      u += r.cross(b).dot(n) / whole;
      v += a.cross(r).dot(n) / whole;
      h = r.dot(n);
    }
    if (h > 0) return;
    result.value = {Mp100(factor * (1 - u) * (1 - v)), Mp100(factor * u * (1 - v)), Mp100(factor * u * v),
                    Mp100(factor * (1 - u) * v)};
  });
  return made;
}

TEST(face_jump, is_measured_on_quads_planar_and_twisted) {
  const Evaluation good = quad_jump(1), bad = quad_jump(1 + 1e-12);
  const Formula& formula = good.formula();
  const Check& check = *find_check("face_jump");
  ASSERT_TRUE(check.applies(formula, good, ScalarKind::Digits100, "on-face"));
  int planar = 0, twisted = 0;
  for (std::uint64_t i = 0; i < 24; ++i) {
    const Sample sample = make_sample(formula, *find_regime("on-face"), 1, i);
    Truth truth;
    truth.on_element = contact_of(formula.element, sample) == Contact::Interior;
    truth.exists[0] = true;
    ResultsAtSample results(sample);
    const Finding right = check.measure({formula, good, ScalarKind::Digits100, sample, 0, truth, results})[0];
    EXPECT_EQ(right.status == Finding::Status::Measured, truth.on_element);
    if (right.status != Finding::Status::Measured) continue;
    ++(i % 3 == 0 ? planar : twisted);
    EXPECT_LT(right.error, 1e-30) << i;
    ResultsAtSample of_bad(sample);
    EXPECT_GT(check.measure({formula, bad, ScalarKind::Digits100, sample, 0, truth, of_bad})[0].error, 1e-30) << i;
  }
  EXPECT_GT(planar, 2);
  EXPECT_GT(twisted, 4);
}

// The potential of a segment of length e vanishes at its ends, L (log L - 1)/(2 pi), and changes by L/(2 pi) with L.
TEST(truth, is_as_sensitive_on_the_border_as_lengths_are) {
  const Formula& formula = formula_named("segment.single_layer");
  const double length = 0x1.5bf0a8b145769p+1;
  for (const int axis : {0, 1}) {
    Sample sample{{{0, 0, 0}, {0, 0, 0}}, {0, 0, 0}, {}, 0, 0};
    sample.corners[1][axis] = length;
    sample.point = sample.corners[1];
    const Truth truth = truth_from(truth_source(formula), sample, 0);
    EXPECT_LT(truth.norm[0], 1e-15);
    // By scaling the axis, and by moving the end with the point.
    EXPECT_NEAR(static_cast<double>(truth.conditioned[0]), 2 * length / (2 * std::numbers::pi), 1e-9);
  }
}

TEST(truth, of_quads_knows_that_the_point_is_on_the_element) {
  const Formula& formula = formula_named("quad.mean_value");
  const Sample sample = make_sample(formula, *find_regime("on-face"), 1, 0);
  ASSERT_EQ(contact_of(formula.element, sample), Contact::Interior);
  EXPECT_TRUE(truth_from(truth_source(formula), sample, 0).on_element);
}

TEST(truth, conditioning_of_the_plain_single_layer_matches_its_scale) {
  // psi is homogeneous of degree one, so sum x_k d psi/d x_k = psi: the yardstick is at least twice the norm.
  const Formula& formula = *find_formula("triangle.single_layer");
  const Sample sample = make_sample(formula, *find_regime("generic"), 5, 3);
  const Truth truth = truth_from(truth_source(formula), sample, 2);
  EXPECT_TRUE(truth.exists[0] && truth.exists[1] && truth.exists[2]);
  EXPECT_GE(truth.conditioned[0], 2 * truth.norm[0] * (1 - 1e-9));
}

TEST(truth, contact_is_exact) {
  Sample sample;
  sample.corners = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  sample.point = {0.25, 0.25, 0};
  EXPECT_EQ(contact_of(ElementKind::Triangle, sample), Contact::Interior);
  sample.point[2] = 5e-324;
  EXPECT_EQ(contact_of(ElementKind::Triangle, sample), Contact::Off);
  sample.point = {0.5, 0.5, 0};
  EXPECT_EQ(contact_of(ElementKind::Triangle, sample), Contact::Border);
  sample.point = {0.75, 0.5, 0};
  EXPECT_EQ(contact_of(ElementKind::Triangle, sample), Contact::Off);
}

// Next to an edge rounding the input may change all digits, and conditioned units forgive as much.
TEST(Digits, are_asked_for_where_conditioned_units_forgive) {
  const Formula& formula = formula_named("triangle.double_layer");
  const Evaluation good = evaluation_named("triangle.double_layer", "hybrid");
  Evaluation off(good.formula().name, good.name(), good.facts());
  off.set_point<double>([good](const Query<double>& query, Result<double>& result) {
    good(query, result);
    for (int o = 0; o <= query.order; ++o)
      for (double& x : result.of(o)) x *= 1 + 1e-12;
  });
  const auto found = [&](const char* check, const Evaluation& evaluation) {
    const Regime* near_edge = find_regime("near-edge");
    const std::uint64_t nearest = near_edge->parameters.size() - 1;
    return measured({find_check(check), &formula, ScalarKind::Double, near_edge}, evaluation, nearest)[1].error;
  };
  EXPECT_LT(found("truth", off), 64);
  EXPECT_GT(found("digits", off), 1e3);
  EXPECT_LT(found("digits", good), 1e3);
}

// Where the truth is zero up to rounding, a thousandth of the terms that cancel is the measure.
TEST(Digits, are_counted_from_what_cancels) {
  const Formula& formula = formula_named("segment.single_layer");
  Sample sample;
  sample.corners = {{0.99, 0, 0}, {1.010033445077928, 0, 0}};
  const Truth truth = truth_from(truth_source(formula), sample, 0);
  Evaluation off(formula.name, "hybrid", evaluation_named(formula.name, "hybrid").facts());
  off.set_point<double>([&](const Query<double>&, Result<double>& result) {
    result.reset(1, 2, 0);
    result.value[0] = static_cast<double>(truth.tensors.value[0]) + 1e-22;
  });
  ResultsAtSample results(sample);
  const auto finding = find_check("digits")->measure({formula, off, ScalarKind::Double, sample, 0, truth, results})[0];
  EXPECT_GT(finding.relative * 0x1p53, 1e3);
  EXPECT_LT(finding.error, 1e2);
}

}  // namespace
}  // namespace cageproof::validation
