// SPDX-License-Identifier: MIT
// The curl form's gradient is wrong triangle by triangle and right for a closed cage's sums; a gradient is right in
// both.
#include "cageproof/core/cage/embedded_cages.h"
#include "cageproof/core/catalogue/evaluation.h"
#include "cageproof/core/input_error.h"
#include "cages/one_ring.h"

#include <gtest/gtest.h>

namespace cageproof::validation {
namespace {

std::vector<ResultRow> rows_of(const char* cage, const char* evaluation) {
  OneRingOptions options;
  options.evaluation = evaluation;
  options.points = 8;
  return run_one_ring_check(embedded_cage(cage), options);
}

TEST(one_ring, curl_form_is_right_in_sums_alone) {
  for (const char* cage : {"cube", "icosphere"})
    for (const ResultRow& row : rows_of(cage, "curl-form")) {
      EXPECT_GT(row.samples, 4u);
      if (row.check == "one_ring_sum") {
        EXPECT_EQ(row.verdict, Verdict::Kept) << cage << ' ' << row.order << ' ' << row.max;
      } else {
        EXPECT_GT(row.median, 0.1) << cage << ' ' << row.order;
        EXPECT_EQ(row.verdict, Verdict::NotPromised);
      }
    }
}

// On a face of 1e-8 of the cage the printed form has no digits in double, and the recommended one has all.
TEST(one_ring, curl_form_promises_nothing_beside_small_faces) {
  const auto rows = rows_of("pinch-1e-8", "curl-form");
  EXPECT_FALSE(rows.empty());
  for (const ResultRow& row : rows) {
    EXPECT_NE(row.check, "one_ring_sum");
    EXPECT_EQ(row.verdict, Verdict::NotPromised) << row.check;
  }
  for (const ResultRow& row : rows_of("pinch-1e-8", "")) EXPECT_EQ(row.verdict, Verdict::Kept) << row.check << row.max;
}

TEST(one_ring, gradients_are_right_in_both) {
  for (const char* evaluation : {"closed_form", "published"})
    for (const ResultRow& row : rows_of("cube", evaluation))
      EXPECT_EQ(row.verdict, Verdict::Kept) << evaluation << ' ' << row.max;
}

// A wrong sign in the curl form would be a plug-in's mistake: neither sums nor triangles are right then.
TEST(one_ring, broken_derivatives_are_found) {
  const auto fill = [](Evaluation& bad) {
    const Evaluation good = evaluation_named("triangle.double_layer", "curl-form");
    bad.set_point<double>([good](const Query<double>& query, Result<double>& result) {
      good(query, result);
      for (double& x : result.gradient) x = -x;
      for (double& x : result.hessian) x = -x;
    });
  };
  const RegisterEvaluation negated{single_family(
      "triangle.double_layer", "negated", {.description = "broken on purpose", .role = Role::Foreign}, false, fill)};
  for (const ResultRow& row : rows_of("cube", "negated")) {
    EXPECT_GT(row.max, 0.1) << row.check;
    EXPECT_EQ(row.verdict, Verdict::Broken) << row.check;
  }
  EXPECT_THROW(rows_of("cube", "no-such-evaluation"), InputError);
}

}  // namespace
}  // namespace cageproof::validation
