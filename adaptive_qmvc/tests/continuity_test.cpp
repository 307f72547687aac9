// SPDX-License-Identifier: MIT
#include "cageproof/adaptive_qmvc/quad/mean_value/continuity.h"
#include "quads.h"

#include <gtest/gtest.h>

namespace cageproof::adaptive_qmvc {
namespace {

Evaluation evaluation(const char* name) { return evaluation_named("quad.mean_value", name); }

TEST(Continuity, FindsJumpsThatAreThere) {
  const WeightsAt step = [](const Vec3<double>& x) { return std::array<double, 4>{x[2] > 0 ? 2. : 1., 0, 0, 0}; };
  const WeightsAt kink = [](const Vec3<double>& x) { return std::array<double, 4>{1 + std::abs(x[2]), x[2], 0, 0}; };
  const WeightsAt smooth = [](const Vec3<double>& x) {
    return std::array<double, 4>{1 + x[2] + x[2] * x[2], x[0], 0, 0};
  };
  const Vec3<double> up = Vec3<double>::UnitZ(), at(.5, 0, 0);
  EXPECT_NEAR(jump_across(step, at, up, 1e-3).value, .5, 1e-9);
  EXPECT_LT(jump_across(kink, at, up, 1e-3).value, 1e-12);
  EXPECT_NEAR(jump_across(kink, at, up, 1e-3).derivative, std::sqrt(2), 1e-6);
  EXPECT_LT(jump_across(smooth, at, up, 1e-3).derivative, 1e-9);
}

// The scheme is continuous across the hull, and no more than that; the integral is smooth there.
TEST(Continuity, OfTheSchemeEndsAtValues) {
  for (const double twist : {.1, .2, .5, 1.}) {
    const Quad<double> q = lifted_square(twist);
    const ContinuityStudy riemann = study_continuity(evaluation("riemann-4"), q, 200, 1),
                          line = study_continuity(evaluation("line_form"), q, 200, 1);
    const auto print = [](const char* what, const Jump& worst, const Jump& median) {
      std::printf("  %s: value %.1e (median %.1e), derivative %.1e (%.1e)\n", what, worst.value, median.value,
                  worst.derivative, median.derivative);
    };
    std::printf("twist %.1f, jumps\n", twist);
    print("riemann-4 at the hull", riemann.hull_worst, riemann.hull_median);
    print("riemann-4 off the hull", riemann.control_worst, riemann.control_median);
    print("line_form at the hull", line.hull_worst, line.hull_median);
    EXPECT_LT(riemann.hull_worst.value, 1e-6);
    EXPECT_GT(riemann.hull_median.derivative, 100 * riemann.control_worst.derivative);
    EXPECT_GT(riemann.hull_median.derivative, 100 * line.hull_median.derivative);
  }
}

TEST(Continuity, RefusesPlanarQuads) {
  EXPECT_THROW(study_continuity(evaluation("riemann-4"), lifted_square(0), 10, 1), std::invalid_argument);
}

}  // namespace
}  // namespace cageproof::adaptive_qmvc
