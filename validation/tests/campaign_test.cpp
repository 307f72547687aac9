// SPDX-License-Identifier: MIT
#include "cageproof/core/input_error.h"
#include "cageproof/reports/worst_file.h"
#include "cageproof/validation/campaign.h"
#include "cageproof/validation/promise.h"
#include "cageproof/validation/replay.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace cageproof::validation {
namespace {

CampaignOptions small() {
  CampaignOptions options;
  options.formulas = "triangle.s*";
  options.regimes = "near-[fp]*";
  options.samples = 48;
  options.quadrature_divisor = 16;
  options.integral_samples = 1;
  return options;
}

std::string fingerprint(const CampaignResult& found) {
  RunResult run;
  run.rows = found.rows;
  std::string text = reports::worst_lines(run);
  for (const ResultRow& row : found.rows)
    text += row.subject + row.evaluation + row.check + std::to_string(row.max) + std::to_string(row.p999) +
            std::to_string(row.samples) + '\n';
  for (const ResultCurve& curve : found.curves)
    for (const double e : curve.errors) text += std::to_string(e) + ' ';
  return text;
}

TEST(campaign, same_result_for_any_number_of_threads) {
  CampaignOptions options = small();
  options.jobs = 1;
  const std::string one = fingerprint(run_campaign(options));
  options.jobs = 3;
  EXPECT_EQ(one, fingerprint(run_campaign(options)));
  options.seed = 2;
  EXPECT_NE(one, fingerprint(run_campaign(options)));
}

TEST(campaign, every_promise_is_kept_and_every_stored_case_replays) {
  const CampaignResult found = run_campaign(small());
  EXPECT_FALSE(found.rows.empty());
  for (const ResultRow& row : found.rows) {
    EXPECT_NE(row.verdict, Verdict::Broken) << row.subject << ' ' << row.evaluation << ' ' << row.check << ' ' << row.max;
    if (row.worst.empty() || row.check == "integral") continue;
    EXPECT_EQ(replay(row, row.worst.front(), Triangulation::Shortest), row.worst.front().error)
        << row.subject << ' ' << row.evaluation << ' ' << row.check;
  }
}

TEST(campaign, enclosures_are_as_many_as_asked_whatever_the_samples) {
  CampaignOptions options;
  options.formulas = "triangle.solid_angle";
  options.regimes = "near-plane";
  options.samples = 1;
  options.enclosures = 3;
  int rows = 0;
  for (const ResultRow& row : run_campaign(options).rows) {
    if (row.check == "truth") {
      EXPECT_EQ(row.samples, 1u) << row.evaluation;
    }
    if (row.check != "enclosure") continue;
    ++rows;
    EXPECT_EQ(row.samples, 3u);
    EXPECT_EQ(row.verdict, Verdict::Kept) << row.max;
  }
  EXPECT_EQ(rows, 3);
}

TEST(campaign, patterns_that_match_nothing_are_bad_input) {
  for (const auto member : {&CampaignOptions::formulas, &CampaignOptions::regimes, &CampaignOptions::evaluations}) {
    CampaignOptions options = small();
    options.*member = "nonsense";
    EXPECT_THROW(run_campaign(options), InputError);
  }
}

TEST(regimes, samples_depend_on_seed_formula_regime_and_index_alone) {
  for (const Regime& regime : regimes())
    for (const Formula& formula : catalogue()) {
      const Sample a = make_sample(formula, regime, 11, 37), b = make_sample(formula, regime, 11, 37);
      EXPECT_EQ(a.point, b.point);
      EXPECT_EQ(a.corners, b.corners);
      EXPECT_NE(a.corners, make_sample(formula, regime, 12, 37).corners);
    }
}

TEST(regimes, samples_in_float_are_floats) {
  for (std::uint64_t i = 0; i < 50; ++i) {
    const Sample s = rounded_to(ScalarKind::Float, make_sample(catalogue()[0], *find_regime("near-edge"), 3, i));
    for (int c = 0; c < 3; ++c) {
      volatile float x = static_cast<float>(s.point[c]), y = static_cast<float>(s.corners[1][c]);
      EXPECT_EQ(s.point[c], static_cast<double>(x));
      EXPECT_EQ(s.corners[1][c], static_cast<double>(y));
    }
  }
}

TEST(regimes, near_face_samples_lie_as_far_away_as_they_say) {
  const Regime& regime = *find_regime("near-face");
  for (std::uint64_t i = 0; i < 400; ++i) {
    const Sample s = make_sample(catalogue()[0], regime, 3, i);
    const auto& t = s.corners;
    const Vec3<double> n = (t[1] - t[0]).cross(t[2] - t[0]).normalized();
    EXPECT_NEAR(std::abs((s.point - t[0]).dot(n)), s.parameter, 1e-15 + 1e-9 * s.parameter);
  }
}

TEST(regimes, on_samples_touch_or_are_one_ulp_off) {
  for (const std::string_view name : {"on-face", "on-edge", "on-vertex"}) {
    int touching = 0;
    for (std::uint64_t i = 0; i < 200; ++i)
      touching += contact_of(make_sample(catalogue()[0], *find_regime(name), 3, i)) != Contact::None;
    EXPECT_GT(touching, 70) << name;
    EXPECT_LT(touching, 170) << name;
  }
}

TEST(promises, nothing_is_promised_without_a_reason) {
  EXPECT_EQ(*promise_for({"truth", "triangle.single_layer", "closed_form", "double", "near-edge", 2}).bound, 64);
  EXPECT_EQ(*promise_for({"truth", "triangle.mean_value", "closed_form", "float", "far", 2}).bound, 64);
  EXPECT_EQ(*promise_for({"relative", "triangle.kelvin_traction", "accurate", "double", "sliver", 1}).bound, 256);
  EXPECT_FALSE(promise_for({"truth", "triangle.single_layer", "published", "double", "generic", 0}).bound);
  EXPECT_FALSE(promise_for({"truth", "triangle.single_layer", "gauss-8", "double", "generic", 0}).bound);
  EXPECT_FALSE(promise_for({"unheard", "of", "", "", "", 0}).reason.empty());
}

TEST(verdicts, a_row_above_its_bound_is_broken) {
  ResultRow row;
  row.subject = "triangle.single_layer";
  row.evaluation = "closed_form";
  row.scalar = "double";
  row.regime = "generic";
  row.check = "truth";
  row.samples = 1;
  row.max = 64;
  judge(row);
  EXPECT_EQ(row.verdict, Verdict::Kept);
  row.max = std::nextafter(64.0, 65.0);
  judge(row);
  EXPECT_EQ(row.verdict, Verdict::Broken);
  row.max = std::numeric_limits<double>::infinity();
  judge(row);
  EXPECT_EQ(row.verdict, Verdict::Broken);
}

}  // namespace
}  // namespace cageproof::validation
