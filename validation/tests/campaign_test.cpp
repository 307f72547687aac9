// SPDX-License-Identifier: MIT
#include "cageproof/core/input_error.h"
#include "cageproof/reports/worst_file.h"
#include "run/campaign.h"
#include "cageproof/validation/promise.h"
#include "cageproof/validation/replay.h"
#include "cageproof/validation/verify.h"

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

std::string fingerprint(const Judged& found) {
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
  const Judged found = run_campaign(small());
  EXPECT_FALSE(found.rows.empty());
  for (const ResultRow& row : found.rows) {
    EXPECT_NE(row.verdict, Verdict::Broken)
        << row.subject << ' ' << row.evaluation << ' ' << row.check << ' ' << row.max;
    if (row.worst.empty() || row.check == "integral") continue;
    EXPECT_EQ(replay(row, row.worst.front(), Triangulation::Shortest).error, row.worst.front().error)
        << row.subject << ' ' << row.evaluation << ' ' << row.check;
  }
}

// Rows against the truth know what a result without a right digit would score, and an error is at most its relative
// error's part of that.
TEST(campaign, rows_say_what_no_right_digit_would_score) {
  int rows = 0, finite = 0;
  for (const ResultRow& row : run_campaign(small()).rows) {
    if (row.check != "truth" || row.scalar != "double" || row.samples == 0) continue;
    ++rows;
    EXPECT_GE(row.total_loss, 0) << row.subject << ' ' << row.evaluation << ' ' << row.setting << ' ' << row.order;
    finite += std::isfinite(row.total_loss);
    if (!(row.max > 0)) continue;
    EXPECT_LE(row.max, 1.001 * row.max_relative * row.total_loss)
        << row.subject << ' ' << row.evaluation << ' ' << row.setting << ' ' << row.order;
  }
  EXPECT_GT(rows, 4);
  EXPECT_GT(finite, 2);
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

// Nothing confirms a derivative where it diverges: the points a rounding off the element must do so for all regimes.
TEST(campaign, the_quickest_suite_confirms_derivatives_next_to_the_element) {
  CampaignOptions options;
  options.formulas = "triangle.single_layer";
  options.evaluations = "closed_form";
  options.samples = suites().front().samples;
  options.integral_samples = suites().front().integral_samples;
  options.enclosures = 0;
  for (const char* regime : {"on-face", "on-edge", "on-vertex"}) {
    options.regimes = regime;
    int rows = 0;
    for (const ResultRow& row : run_campaign(options).rows) {
      if (row.check != "truth" || row.scalar != "double") continue;
      ++rows;
      // Hessians diverge towards edges: no result could break a promise there, which says so, and is no promise.
      const bool diverges = row.order == 2 && row.is_ill_posed() && regime != std::string_view("on-face");
      EXPECT_TRUE(row.verdict == Verdict::Kept || (diverges && row.verdict == Verdict::NotPromised))
          << row.subject << ", " << regime << ", order " << row.order << ": " << row.reason;
      EXPECT_GT(row.samples, 0U);
    }
    EXPECT_EQ(rows, 3);
  }
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
      if (!exists_for(regime, formula.element)) continue;
      const Sample a = make_sample(formula, regime, 11, 37), b = make_sample(formula, regime, 11, 37);
      EXPECT_EQ(a.point, b.point);
      EXPECT_EQ(a.corners, b.corners);
      EXPECT_NE(a.corners, make_sample(formula, regime, 12, 37).corners);
    }
}

TEST(regimes, samples_in_float_are_floats) {
  for (std::uint64_t i = 0; i < 50; ++i) {
    const Sample s = rounded_to(ScalarKind::Float, make_sample(catalogue().front(), *find_regime("near-edge"), 3, i));
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
    const Sample s = make_sample(catalogue().front(), regime, 3, i);
    const auto& t = s.corners;
    const Vec3<double> n = (t[1] - t[0]).cross(t[2] - t[0]).normalized();
    EXPECT_NEAR(std::abs((s.point - t[0]).dot(n)), s.parameter, 1e-15 + 1e-9 * s.parameter);
  }
}

TEST(regimes, on_samples_touch_or_are_one_ulp_off) {
  for (const std::string_view name : {"on-face", "on-edge", "on-vertex"}) {
    int touching = 0;
    for (std::uint64_t i = 0; i < 200; ++i)
      touching +=
          contact_of(ElementKind::Triangle, make_sample(catalogue().front(), *find_regime(name), 3, i)) != Contact::Off;
    EXPECT_GT(touching, 70) << name;
    EXPECT_LT(touching, 170) << name;
  }
}

TEST(promises, nothing_is_promised_without_a_reason) {
  EXPECT_EQ(*promise_for({"truth", "triangle.single_layer", "closed_form", "double", "near-edge", 2}).bound, 64);
  EXPECT_EQ(*promise_for({"truth", "triangle.mean_value", "closed_form", "float", "far", 2}).bound, 64);
  EXPECT_EQ(*promise_for({"relative", "triangle.kelvin_traction", "accurate", "double", "sliver", 1}).bound, 256);
  EXPECT_FALSE(promise_for({"truth", "triangle.single_layer", "published", "double", "near-edge", 0}).bound);
  EXPECT_FALSE(promise_for({"truth", "triangle.single_layer", "gauss-8", "double", "generic", 0}).bound);
  EXPECT_FALSE(promise_for({"unheard", "of", "", "", "", 0}).reason.empty());
}

TEST(promises, of_recommended_evaluations_hold_whatever_they_are_called) {
  for (const char* check : {"truth", "subdivision", "scaling"})
    EXPECT_EQ(promise_for({check, "quad.mean_value", "line_form", "double", "generic", 0}).bound,
              promise_for({check, "triangle.mean_value", "closed_form", "double", "generic", 0}).bound);
  const Evaluation line_form = evaluation_named("quad.mean_value", "closed_form");
  EXPECT_EQ(line_form.name(), "line_form");
  EXPECT_TRUE(matches_evaluation("closed_*", line_form));
  EXPECT_TRUE(matches_evaluation("line_form", line_form));
  EXPECT_FALSE(matches_evaluation("gauss-*", line_form));
}

// A formula that has only a kernel: its truth comes from its integral.
struct KernelAlone {
  static constexpr std::string_view name = "triangle.kernel_alone";
  KernelAlone() {
    [[maybe_unused]] static const RegisterFormula row = [] {
      Formula formula = formula_named("triangle.solid_angle");
      formula.name = name;
      return RegisterFormula(formula);
    }();
    const auto borrowed = [](std::string_view from, Role role, CostClass cost) {
      return single_family(
          name, from, {.description = "borrowed", .role = role, .cost = cost, .max_order = 1}, true,
          [from](Evaluation& made) {
            const Evaluation lender = evaluation_named("triangle.solid_angle", from);
            for (const ScalarKind kind : scalar_kinds)
              with_scalar(kind, [&]<Scalar R>() {
                made.set_point<R>([lender](const Query<R>& query, Result<R>& result) { lender(query, result); });
              });
          });
    };
    [[maybe_unused]] static const RegisterEvaluation integral{
        borrowed("multiprecision", Role::Integral, CostClass::Multiprecision)};
    [[maybe_unused]] static const RegisterEvaluation rule{borrowed("gauss-8", Role::Rule, CostClass::Nodes)};
  }
};

TEST(campaign, a_formula_with_a_kernel_alone_has_the_integral_for_its_truth) {
  const KernelAlone formula;
  const TruthSource source = truth_source(formula_named(formula.name));
  EXPECT_TRUE(source.is_integral());
  EXPECT_TRUE(source.is_costly());
  const Sample sample = make_sample(formula_named(formula.name), *find_regime("generic"), 1, 0);
  const Truth truth = truth_from(source, sample, 1);
  const Truth closed = truth_from(truth_source(formula_named("triangle.solid_angle")), sample, 1);
  for (int o = 0; o < 2; ++o) {
    ASSERT_TRUE(truth.exists[o]);
    EXPECT_LT(abs(truth.norm[o] - closed.norm[o]), 1e-30 * closed.norm[o]);
    // Differences of a rough yardstick are good to a few digits.
    EXPECT_LT(abs(truth.conditioned[o] - closed.conditioned[o]), 1e-3 * closed.conditioned[o]);
  }
  CampaignOptions options = small();
  options.formulas = formula.name;
  options.regimes = "generic";
  options.samples = 4;
  const Judged found = run_campaign(options);
  ASSERT_FALSE(found.rows.empty());
  for (const ResultRow& row : found.rows) {
    EXPECT_EQ(row.evaluation, "gauss-8");
    EXPECT_EQ(row.check, "truth");
    EXPECT_EQ(row.verdict, Verdict::NotPromised);
    EXPECT_GT(row.samples, 0u);
  }
  EXPECT_TRUE(
      std::ranges::any_of(found.notes, [&](const std::string& note) { return note.starts_with(formula.name); }));
}

ResultRow declining_row() {
  [[maybe_unused]] static const RegisterEvaluation declining{
      single_family("triangle.single_layer", "declining", {.description = "never answers", .role = Role::Foreign},
                    false, [](Evaluation& made) {
                      made.set_point<double>([](const Query<double>& query, Result<double>& result) {
                        result.reset(1, 3, query.order);
                        result.converged = false;
                      });
                    })};
  ResultRow row;
  row.subject = "triangle.single_layer";
  row.evaluation = "declining";
  row.scalar = "double";
  row.setting = "generic";
  row.check = "truth";
  return row;
}

TEST(replay, says_that_an_evaluation_declined) {
  const WorstCase worst{.corners = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, .point = {0.2, 0.3, 0.5}};
  const Finding found = replay(declining_row(), worst, Triangulation::Shortest);
  EXPECT_EQ(found.status, Finding::Status::Declined);
}

TEST(replay, says_that_there_is_no_truth) {
  ResultRow row = declining_row();
  row.subject = "triangle.double_layer";
  row.evaluation = "closed_form";
  row.order = 1;
  // The gradient at an edge depends on the direction.
  const WorstCase worst{.corners = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, .point = {0.25, 0, 0}};
  EXPECT_EQ(replay(row, worst, Triangulation::Shortest).status, Finding::Status::NoTruth);
}

TEST(verdicts, a_row_above_its_bound_is_broken) {
  ResultRow row;
  row.subject = "triangle.single_layer";
  row.evaluation = "closed_form";
  row.scalar = "double";
  row.setting = "generic";
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

// Most limits of tractions on edges do not exist. However few samples are asked, none breaks a promise for that.
// Runs with 1, 2, ... samples, none of which may break a promise. Returns how many rows are undecided.
std::size_t undecided_up_to(int most_samples, CampaignOptions options) {
  std::size_t undecided = 0;
  options.integral_samples = 2;
  options.enclosures = 0;
  for (options.samples = 1; options.samples <= most_samples; ++options.samples)
    for (const ResultRow& row : run_campaign(options).rows) {
      EXPECT_NE(row.verdict, Verdict::Broken)
          << options.samples << " samples: " << row.subject << ' ' << row.check << ' ' << row.reason;
      undecided += row.verdict == Verdict::Undecided;
    }
  return undecided;
}

TEST(campaign, of_few_samples_breaks_nothing) {
  CampaignOptions options;
  options.formulas = "triangle.kelvin_traction";
  options.evaluations = "closed_form";
  options.regimes = "on-edge";
  EXPECT_GT(undecided_up_to(3, options), 0u);
  // Those whose integrals take little time.
  options.formulas = "segment.single_layer,segment.double_layer,segment.mean_value";
  options.evaluations = "closed_form,hybrid";
  options.regimes = "on-edge,on-vertex";
  undecided_up_to(12, options);
}

}  // namespace
}  // namespace cageproof::validation
