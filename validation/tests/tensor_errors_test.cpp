// SPDX-License-Identifier: MIT
// Errors entry by entry: what is infinite, what has no limit, and what leaves a scalar's range.
#include "cageproof/core/catalogue/evaluation.h"
#include "cageproof/validation/check.h"
#include "cageproof/validation/truth.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace cageproof::validation::tensor_errors_test {
namespace {

constexpr double inf = std::numeric_limits<double>::infinity(), nan = std::numeric_limits<double>::quiet_NaN();
constexpr double u = 0x1p-53, most = std::numeric_limits<double>::max();

Truth truth_of(const std::vector<Mp100>& tensor) {
  Truth truth;
  truth.tensors.value = tensor;
  std::vector<Mp100> finite;
  for (const Mp100& x : tensor)
    if (isfinite(x)) finite.push_back(x);
  truth.norm[0] = truth.conditioned[0] = norm(finite);
  truth.exists[0] = finite.size() == tensor.size();
  truth.partial[0] = !truth.exists[0];
  return truth;
}

double error(const std::vector<double>& found, const std::vector<Mp100>& tensor) {
  Result<double> f;
  f.value = found;
  return conditioned_error(f, truth_of(tensor), 0, Mp100(u));
}

TEST(tensor_errors, are_norms_of_finite_tensors) {
  EXPECT_EQ(error({1, 2, 2}, {1, 2, 2}), 0);
  EXPECT_NEAR(error({1, 2, 2 + 4 * u}, {1, 2, 2}), 4.0 / 3, 1e-12);
  EXPECT_EQ(error({1, nan, 2}, {1, 2, 2}), inf);
  EXPECT_EQ(error({1, inf, 2}, {1, 2, 2}), inf);
}

TEST(tensor_errors, of_a_result_without_a_right_digit_are_as_large_as_the_truth) {
  Truth truth = truth_of({1, 2, 2});
  EXPECT_NEAR(score_of_total_loss(truth, 0, Mp100(u)) * u, 1, 1e-12);
  EXPECT_NEAR(error({0, 0, 0}, {1, 2, 2}), score_of_total_loss(truth, 0, Mp100(u)), 1e-3);
  // Rounding the input costs sixteen digits here: nothing could be wrong.
  truth.conditioned[0] = truth.norm[0] * Mp100("1e16");
  EXPECT_LT(score_of_total_loss(truth, 0, Mp100(u)), 1);
  // A nonzero entry whose truth is zero is an error, and so is a finite one where no limit exists.
  EXPECT_EQ(score_of_total_loss(truth_of({0, 0}), 0, Mp100(u)), inf);
  EXPECT_EQ(score_of_total_loss(truth_of({1, Mp100(inf)}), 0, Mp100(u)), inf);
}

TEST(tensor_errors, compare_signs_of_infinities_and_what_stands_beside_them) {
  const std::vector<Mp100> truth{Mp100(inf), Mp100(-inf), 3};
  EXPECT_EQ(error({inf, -inf, 3}, truth), 0);
  EXPECT_EQ(error({inf, inf, 3}, truth), inf);
  EXPECT_EQ(error({1e300, -inf, 3}, truth), inf);
  EXPECT_EQ(error({inf, -inf, nan}, truth), inf);
  EXPECT_NEAR(error({inf, -inf, 7.5}, truth) * u, 1.5, 1e-12);
}

TEST(tensor_errors, let_nothing_be_invented_where_no_limit_is) {
  EXPECT_EQ(error({nan, 3}, {Mp100(nan), 3}), 0);
  EXPECT_EQ(error({2, 3}, {Mp100(nan), 3}), inf);
  EXPECT_EQ(error({inf, 3}, {Mp100(nan), 3}), inf);
}

TEST(tensor_errors, take_an_infinity_for_what_doubles_cannot_hold) {
  const Mp100 beyond = Mp100("1e400");
  EXPECT_EQ(error({inf, 1}, {beyond, 1}), 0);
  EXPECT_EQ(error({-inf, 1}, {beyond, 1}), inf);
  EXPECT_EQ(error({most, 1}, {beyond, 1}), inf);
  // Entries below a rounding of the largest one are ignored; larger ones have a norm of their own.
  EXPECT_EQ(error({inf, 2.5}, {beyond, 1}), 0);
  EXPECT_EQ(error({inf, inf}, {beyond, -1}), 0);
  EXPECT_EQ(error({inf, std::numeric_limits<double>::quiet_NaN()}, {beyond, 1}), inf);
  EXPECT_NEAR(error({inf, 2.5e300}, {Mp100("1e310"), Mp100("1e300")}) * u, 1.5, 1e-12);
  // Next to the largest double rounding decides.
  EXPECT_EQ(error({inf}, {Mp100(most)}), 0);
  EXPECT_LT(error({most}, {Mp100(most) * (1 + Mp100(u) / 2)}), 1);
  EXPECT_EQ(error({inf}, {Mp100("1e300")}), inf);
}

TEST(tensor_errors, forgive_one_denormal_below_the_normal_range) {
  const double least = std::numeric_limits<double>::denorm_min();
  EXPECT_EQ(error({1000 * least}, {Mp100(least) * Mp100("999.1")}), 0);
  EXPECT_EQ(error({0}, {Mp100("1e-400")}), 0);
  EXPECT_GT(error({1002 * least}, {Mp100(1000 * least)}), 64);
  // Normal numbers have their digits.
  EXPECT_GT(error({0x1p-1000 + 0x1p-1040}, {Mp100(0x1p-1000)}), 64);
}

TEST(tensor_errors, hold_statements_to_their_digits) {
  Result<double> f;
  f.value = {1 + 2e-9, 0};
  const Truth truth = truth_of({1, 0});
  EXPECT_NEAR(error_over_digits(f, truth, 0, 8), 0.2, 1e-6);
  EXPECT_NEAR(error_over_digits(f, truth, 0, 9), 2, 1e-6);
  // A denormal has few digits, and whoever states more of one is wrong.
  const double least = std::numeric_limits<double>::denorm_min();
  f.value = {3 * least};
  EXPECT_GT(error_over_digits(f, truth_of({Mp100(least) * Mp100("3.4")}), 0, 14), 1);
}

// `accurate` with so many digits more than it stands behind.
template <int Digits>
EvaluationFamily boasting(const char* name) {
  return single_family("triangle.single_layer", name,
                       {.description = "overstates", .role = Role::Stated, .states_error = true}, false,
                       [](Evaluation& bad) {
                         const Evaluation good = evaluation_named("triangle.single_layer", "accurate");
                         bad.set_point<double>([good](const Query<double>& query, Result<double>& result) {
                           good(query, result);
                           // As wrong as it says, within a digit.
                           const double share = 0.5 * std::pow(10, -result.stated_digits);
                           for (int o = 0; o <= query.order; ++o)
                             for (double& x : result.of(o)) x += share * x;
                           result.stated_digits += Digits;
                         });
                       });
}
const RegisterEvaluation honest{boasting<0>("states_0_more")}, boasts{boasting<2>("states_2_more")};

TEST(stated_error, holds_the_statement_itself) {
  const Formula& formula = formula_named("triangle.single_layer");
  const Check& check = *find_check("stated_error");
  for (const double height : {0.3, 1e-3, 1e-9}) {
    // In a frame whose rounding costs as much as two digits more or less.
    const Sample sample{{{100, 100, 100}, {101, 100, 100}, {100, 101, 100}}, {100.25, 100.25, 100 + height}, {}, 0, 0};
    const Truth truth = truth_from(truth_source(formula), sample, 2);
    ResultsAtSample results(sample);
    const auto error = [&](const char* evaluation, int order) {
      return check
          .measure({formula, evaluation_named(formula.name, evaluation), ScalarKind::Double, sample, 2, truth,
                    results})[order]
          .error;
    };
    for (int o = 0; o < 3; ++o) {
      EXPECT_LT(error("states_0_more", o), 1) << height << ' ' << o;
      EXPECT_GT(error("states_2_more", o), 1) << height << ' ' << o;
    }
  }
}

// The closed form, with a border value that is wrong next to the infinite entries.
template <Scalar R>
void set_wrong(Evaluation& bad, const std::string& how) {
  const Evaluation good = evaluation_named("triangle.single_layer", "closed_form");
  bad.set_point<R>([good, how](const Query<R>& query, Result<R>& result) {
    good(query, result);
    using std::isfinite, std::isinf;
    if (!std::ranges::any_of(result.gradient, [](const R& x) { return static_cast<bool>(isinf(x)); })) return;
    for (R& x : result.gradient) {
      if (how == "finite" && isfinite(x)) x = x * 5 / 2;
      if (how == "sign" && isinf(x)) x = -x;
      if (how == "lost") x = std::numeric_limits<R>::quiet_NaN();
    }
  });
}

EvaluationFamily wrong(const char* name, const char* how) {
  return single_family("triangle.single_layer", name, {.description = "wrong on the border", .role = Role::Stated},
                       false, [how](Evaluation& bad) {
                         set_wrong<double>(bad, how);
                         set_wrong<Mp200>(bad, how);
                       });
}
const RegisterEvaluation wrong_finite{wrong("border_finite", "finite")}, wrong_sign{wrong("border_sign", "sign")},
    wrong_lost{wrong("border_lost", "lost")};

// On the edge's middle the gradient is infinite across the edge, zero along it, and finite off the plane.
double border_error(const char* check, const char* evaluation, ScalarKind scalar) {
  const Formula& formula = formula_named("triangle.single_layer");
  const Sample sample{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {0.5, 0, 0}, {}, 0, 0};
  const Truth truth = truth_from(truth_source(formula), sample, 1);
  EXPECT_TRUE(truth.exists[0]);
  EXPECT_TRUE(truth.partial[1]);
  ResultsAtSample results(sample);
  const Finding finding = find_check(check)->measure(
      {formula, evaluation_named(formula.name, evaluation), scalar, sample, 1, truth, results})[1];
  return finding.status == Finding::Status::Measured ? finding.error : -1;
}

TEST(border_values, are_compared_entry_by_entry) {
  EXPECT_LT(border_error("truth", "closed_form", ScalarKind::Double), 64);
  EXPECT_GE(border_error("truth", "closed_form", ScalarKind::Double), 0);
  for (const char* evaluation : {"border_finite", "border_sign", "border_lost"})
    EXPECT_GT(border_error("truth", evaluation, ScalarKind::Double), 64) << evaluation;
  // Rules do not know limits, and are not asked.
  EXPECT_EQ(border_error("truth", "gauss-8", ScalarKind::Double), -1);
}

TEST(border_values, are_what_is_approached_from_inside) {
  const double good = border_error("limit", "closed_form", ScalarKind::Digits200);
  EXPECT_LT(good, 1e-30);
  EXPECT_GE(good, 0);
  for (const char* evaluation : {"border_finite", "border_sign"})
    EXPECT_GT(border_error("limit", evaluation, ScalarKind::Digits200), 1e-30) << evaluation;
}

}  // namespace
}  // namespace cageproof::validation::tensor_errors_test
