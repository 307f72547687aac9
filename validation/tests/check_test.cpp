// SPDX-License-Identifier: MIT
// A check that cannot fail is a defect: each is shown an evaluation that is wrong in the way it looks for.
#include "cageproof/validation/check.h"
#include "cageproof/validation/promise.h"
#include "cageproof/validation/regime.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace cageproof::validation {
namespace {

// The closed form plus a term that has no symmetry, no scaling and no harmonic partner, and whose gradient is not its gradient.
Evaluation broken(const std::string& formula, double size) {
  const Evaluation good = *EvaluationRegister::instance().find(formula, "closed_form");
  Evaluation bad(formula, "closed_form", "broken on purpose");
  for (const ScalarKind kind : scalar_kinds)
    with_scalar(kind, [&]<Scalar R>() {
      bad.set<R>([good, size](const Query<R>& query, Result<R>& result) {
        good(query, result);
        const R x = query.point[0] + 2 * query.corners[0][1] + 3 * query.corners[1][2] + R(1) / 3;
        // Odd in the height's sign, so that the jump across a face is wrong too.
        const Vec3<R> a = query.corners[1] - query.corners[0], b = query.corners[2] - query.corners[0];
        const R height = a.cross(b).dot(Vec3<R>(query.point - query.corners[0]));
        const R term = R(size) * (x * x * x + (height < 0 ? R(1) : R(-1)) / 7);
        for (int o = 0; o <= query.order; ++o)
          for (std::size_t i = 0; i < result.of(o).size(); ++i) result.of(o)[i] += R(static_cast<int>(i % 5) + 1) * term;
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
  const Truth truth = truth_from(*EvaluationRegister::instance().find(s.formula->name, "closed_form"), sample, 2);
  return s.check->measure({*s.formula, evaluation, s.scalar, sample, 2, truth});
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

class every_check : public testing::TestWithParam<std::string> {};

TEST_P(every_check, passes_the_closed_form_and_fails_a_broken_one) {
  const Check* check = find_check(GetParam());
  const bool jump = GetParam() == "face_jump";
  const bool stated = GetParam() == "stated_error";
  const ScalarKind scalar = GetParam() == "gradient_by_differences" ? ScalarKind::Digits200
                            : check->unit() == "relative"           ? ScalarKind::Digits100
                                                                    : ScalarKind::Double;
  const Setting setting{check, find_formula("triangle.double_layer"), scalar, find_regime(jump ? "on-face" : "generic")};
  const Evaluation good = *EvaluationRegister::instance().find(
      setting.formula->name, stated ? "adaptive" : GetParam() == "relative" ? "accurate" : "closed_form");
  const auto right = largest(setting, good);
  const auto wrong = largest(setting, broken(std::string(setting.formula->name), 1e-6));
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

std::vector<std::string> check_names() {
  std::vector<std::string> names;
  for (const auto& check : checks()) names.emplace_back(check->name());
  return names;
}

INSTANTIATE_TEST_SUITE_P(all, every_check, testing::ValuesIn(check_names()), [](const auto& i) { return i.param; });

TEST(truth, conditioning_of_the_plain_single_layer_matches_its_scale) {
  // psi is homogeneous of degree one, so sum x_k d psi/d x_k = psi: the yardstick is at least twice the norm.
  const Formula& formula = *find_formula("triangle.single_layer");
  const Sample sample = make_sample(formula, *find_regime("generic"), 5, 3);
  const Truth truth = truth_from(*EvaluationRegister::instance().find(formula.name, "closed_form"), sample, 2);
  EXPECT_TRUE(truth.exists[0] && truth.exists[1] && truth.exists[2]);
  EXPECT_GE(truth.conditioned[0], 2 * truth.norm[0] * (1 - 1e-9));
}

TEST(truth, contact_is_exact) {
  Sample sample;
  sample.corners = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  sample.point = {0.25, 0.25, 0};
  EXPECT_EQ(contact_of(sample), Contact::Face);
  sample.point[2] = 5e-324;
  EXPECT_EQ(contact_of(sample), Contact::None);
  sample.point = {0.5, 0.5, 0};
  EXPECT_EQ(contact_of(sample), Contact::Border);
  sample.point = {0.75, 0.5, 0};
  EXPECT_EQ(contact_of(sample), Contact::None);
}

}  // namespace
}  // namespace cageproof::validation
