// SPDX-License-Identifier: MIT
// The one way from a tally to a judged row, and what replay makes of samples that were not measured.
#include "promises/verdicts.h"

#include "cageproof/core/input_error.h"
#include "cageproof/reports/worst_file.h"
#include "cageproof/validation/hunt.h"
#include "cageproof/validation/regime.h"
#include "cageproof/validation/replay.h"
#include "cageproof/validation/stored_cases.h"

#include <gtest/gtest.h>

#include <cmath>

namespace cageproof::validation {
namespace {

RowKey key(const char* check, const char* evaluation, const char* regime, int order = 0) {
  return {RowKey::Section::Element, "triangle.single_layer", evaluation, "double", regime, check, "", order};
}

// One sample of that error, none where it is negative, and others that had no truth.
Tally tally(double error, std::uint64_t without_truth = 0) {
  Tally found;
  found.unit = "conditioned";
  if (error >= 0)
    found.add(error, error * 1e-16, 7, [](double e) {
      WorstCase worst;
      worst.error = e;
      return worst;
    });
  found.without_truth = without_truth;
  found.asked = found.errors.count() + without_truth;
  return found;
}

TEST(rows, hold_every_figure_of_their_tally) {
  Tally found = tally(3);
  found.merge(tally(50, 2));
  found.declined = 4;
  found.asked += 4;
  const ResultRow row = row_of(key("truth", "gauss-8", "on-face"), found);
  EXPECT_EQ(static_cast<const RowKey&>(row), key("truth", "gauss-8", "on-face"));
  EXPECT_EQ(row.unit, "conditioned");
  EXPECT_EQ(row.samples, 2u);
  EXPECT_EQ(row.asked, 8u);
  EXPECT_EQ(row.max, 50);
  EXPECT_EQ(row.p999, 50);
  EXPECT_EQ(row.median, found.errors.median());
  EXPECT_EQ(row.max_relative, 50 * 1e-16);
  EXPECT_EQ(row.without_truth, 2u);
  EXPECT_EQ(row.declined, 4u);
  EXPECT_EQ(row.worst.size(), 2u);
  EXPECT_EQ(row.histogram.size(), found.errors.counts().size());
  EXPECT_EQ(row.verdict, Verdict::NotPromised);
}

TEST(rows, judge_what_their_samples_are) {
  const ResultRow row = row_of(key("truth", "closed_form", "on-edge"), tally(3, 1));
  EXPECT_EQ(*row.bound, 64);
  EXPECT_EQ(row.verdict, Verdict::Kept);
  // Where no limit exists there is nothing to keep, and nothing to break.
  EXPECT_EQ(row_of(key("truth", "closed_form", "on-edge"), tally(-1, 3)).verdict, Verdict::NotPromised);
}

// A bound that a result without a right digit would meet is no promise, unless some sample would show the loss.
TEST(rows, promise_nothing_that_no_result_could_break) {
  Tally found = tally(3);
  for (const double loss : {0.0, 12.5, 64.0}) {
    found.total_loss = loss;
    const ResultRow row = row_of(key("truth", "closed_form", "on-edge"), found);
    EXPECT_EQ(row.total_loss, loss);
    EXPECT_TRUE(row.is_ill_posed()) << loss;
    EXPECT_EQ(row.verdict, Verdict::NotPromised) << loss;
    EXPECT_TRUE(row.reason.starts_with("ill-posed here: ")) << row.reason;
    EXPECT_EQ(*row.bound, 64);
  }
  for (const double loss : {-1.0, 64.5, HUGE_VAL}) {
    found.total_loss = loss;
    const ResultRow row = row_of(key("truth", "closed_form", "on-edge"), found);
    EXPECT_FALSE(row.is_ill_posed()) << loss;
    EXPECT_EQ(row.verdict, Verdict::Kept) << loss;
  }
  // Above the bound it is broken all the same, and without a bound there is nothing to be ill-posed about.
  Tally broken = tally(65);
  broken.total_loss = 1;
  EXPECT_EQ(row_of(key("truth", "closed_form", "on-edge"), broken).verdict, Verdict::Broken);
  EXPECT_FALSE(row_of(key("truth", "gauss-8", "on-edge"), broken).is_ill_posed());
  // One sample that would show it is enough.
  found.total_loss = 1;
  Tally other = tally(2);
  other.total_loss = 1e15;
  found.merge(other);
  EXPECT_EQ(row_of(key("truth", "closed_form", "on-edge"), found).verdict, Verdict::Kept);
}

// A journal says what an evaluation was when it was measured; only one that does not say is looked up.
TEST(rows, have_the_role_that_their_tally_has) {
  Tally found = tally(3);
  EXPECT_EQ(row_of(key("truth", "hybrid", "on-edge"), found).role, "recommended");
  EXPECT_EQ(row_of(key("truth", "closed_form", "on-edge"), found).role, "closed form");
  found.role = "rule";
  found.declined = 2;
  found.asked += 2;
  const ResultRow row = row_of(key("truth", "closed_form", "on-edge"), found);
  EXPECT_EQ(row.role, "rule");
  EXPECT_EQ(lost_samples(row), 0u) << "a rule may decline";
}

TEST(rows, are_broken_by_samples_that_they_lost) {
  Tally unreached = tally(3), declined = tally(3), vanished = tally(3);
  unreached.unreached = declined.declined = 2;
  for (Tally* lost : {&unreached, &declined, &vanished}) lost->asked += 2;
  for (const Tally& lost : {unreached, declined, vanished}) {
    const ResultRow row = row_of(key("truth", "closed_form", "on-edge"), lost);
    EXPECT_EQ(row.verdict, Verdict::Broken);
    EXPECT_EQ(lost_samples(row), 2u);
    EXPECT_TRUE(row.reason.starts_with("2 of 3 samples are lost: 2 ")) << row.reason;
  }
  // All of them, which leaves no error to judge.
  Tally nothing = tally(-1);
  nothing.asked = 231;
  EXPECT_EQ(row_of(key("scaling", "closed_form", "near-edge"), nothing).verdict, Verdict::Broken);
  // The same holds for cages.
  const RowKey cage{RowKey::Section::Cage, "green", "closed_form", "double", "cube", "limit_from_inside", "on-edge", 0};
  EXPECT_EQ(row_of(cage, unreached).verdict, Verdict::Broken);
  // Where nothing is promised, or declining is allowed, such samples are only counted.
  EXPECT_EQ(row_of(key("truth", "gauss-8", "on-edge"), unreached).verdict, Verdict::NotPromised);
  declined = tally(0.5);
  declined.declined = 2;
  declined.asked += 2;
  EXPECT_EQ(row_of(key("stated_error", "adaptive", "generic"), declined).verdict, Verdict::Kept);
  EXPECT_EQ(row_of(key("stated_error", "accurate", "generic"), declined).verdict, Verdict::Broken);
}

// Declined samples are no loss for an evaluation that may decline; for any other they are.
TEST(rows, say_only_of_what_is_lost_where_it_went) {
  Tally found = tally(0.5);
  found.declined = 2;
  found.unreached = 1;
  found.asked += 4;
  const ResultRow row = row_of(key("stated_error", "adaptive", "generic"), found);
  EXPECT_EQ(row.verdict, Verdict::Broken);
  EXPECT_EQ(row.reason, "2 of 5 samples are lost: 1 had no truth or figure though a limit exists, 1 were not heard of");
  Tally worse = tally(65);
  worse.declined = 2;
  worse.asked += 2;
  const ResultRow both = row_of(key("truth", "closed_form", "on-edge"), worse);
  EXPECT_TRUE(both.reason.ends_with("; 2 of 3 samples are lost: 2 were declined")) << both.reason;
}

TEST(rows, have_a_curve_of_what_was_measured_at_each_parameter) {
  Tally found = tally(3);
  found.by_parameter = {0, -1, 3};
  const std::vector<double>& parameters = find_regime("near-edge")->parameters;
  const Judged one = judged({{key("truth", "closed_form", "near-edge"), found}});
  ASSERT_EQ(one.curves.size(), 1u);
  EXPECT_EQ(one.curves[0].parameters, (std::vector<double>{parameters[0], parameters[2]}));
  EXPECT_EQ(one.curves[0].errors, (std::vector<double>{0, 3}));
}

RowKey gate_at(const char* regime) {
  RowKey gate = key("integral", "closed_form", regime);
  gate.scalar = "mp100";
  return gate;
}

TEST(rows, without_an_integral_behind_them_leave_its_own_row_undecided_and_break_it_in_a_whole_suite) {
  Tally declined = tally(-1);
  declined.declined = declined.asked = 2;
  for (const auto& [samples, verdict] :
       {std::pair(Samples::All, Verdict::Broken), std::pair(Samples::Fewer, Verdict::Undecided)})
    for (const Tally& none : {declined, tally(-1, 4), tally(-1, 3)}) {
      std::map<RowKey, Tally> tallies{{gate_at("on-face"), none}, {key("truth", "closed_form", "on-face"), tally(3)}};
      for (const ResultRow& row : judged(std::map(tallies), samples).rows)
        EXPECT_EQ(row.verdict, row.check == "integral" ? verdict : Verdict::NotPromised);
      // Broken rows stay broken.
      tallies[key("truth", "closed_form", "on-face")] = tally(65);
      for (const ResultRow& row : judged(std::map(tallies), samples).rows)
        EXPECT_EQ(row.verdict, row.check == "integral" ? verdict : Verdict::Broken);
      // Where nothing has a limit, nothing rests on it.
      tallies[key("truth", "closed_form", "on-face")] = tally(-1, 3);
      for (const ResultRow& row : judged(std::map(tallies), samples).rows) EXPECT_EQ(row.verdict, Verdict::NotPromised);
    }
}

TEST(rows, that_are_undecided_name_an_input) {
  Tally found;
  found.add(3, 3e-16, 7, [](double error) {
    WorstCase worst;
    worst.error = error;
    worst.corners = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    worst.point = {0.25, 0, 0};
    return worst;
  });
  found.asked = 1;
  for (const ResultRow& row :
       judged({{gate_at("on-edge"), tally(-1, 2)}, {key("truth", "closed_form", "on-edge"), found}}).rows)
    if (row.check == "integral") {
      EXPECT_TRUE(row.reason.starts_with("not enough samples: ")) << row.reason;
      EXPECT_NE(row.reason.find("measured for instance at ("), std::string::npos) << row.reason;
    }
}

TEST(rows, are_withdrawn_where_the_integral_is_another) {
  std::map<RowKey, Tally> tallies;
  tallies[gate_at("near-edge")] = tally(1);
  tallies[key("truth", "closed_form", "near-edge")] = tally(3);
  tallies[key("truth", "closed_form", "near-face")] = tally(3);
  tallies[key("truth", "closed_form", "near-edge", 1)] = tally(3);
  const Judged found = judged(std::map(tallies));
  ASSERT_EQ(found.notes.size(), 1u);
  for (const ResultRow& row : found.rows)
    if (row.check == "truth") {
      EXPECT_EQ(row.verdict, row.setting == "near-edge" && row.order == 0 ? Verdict::NotPromised : Verdict::Kept)
          << row.setting << row.order;
    }
}

TEST(rows, stand_in_the_order_of_the_catalogue) {
  std::map<RowKey, Tally> tallies;
  for (const char* regime : {"hunted", "near-edge", "generic"})
    for (const char* evaluation : {"gauss-8", "closed_form"})
      for (const char* check : {"scaling", "truth"}) tallies[key(check, evaluation, regime)] = tally(1);
  RowKey solid = key("truth", "closed_form", "generic"),
         cage{RowKey::Section::Cage, "green", "closed_form", "double", "torus", "zero_outside", "outside", 0};
  solid.subject = "triangle.solid_angle";
  tallies[solid] = tallies[cage] = tally(1);
  std::string order;
  for (const ResultRow& row : judged(std::map(tallies)).rows)
    order += row.subject + " " + row.setting + " " + row.check + " " + row.evaluation + "\n";
  EXPECT_EQ(order.substr(0, order.find('\n')), "triangle.single_layer generic truth closed_form");
  EXPECT_LT(order.find("truth gauss-8"), order.find("scaling"));
  EXPECT_LT(order.find("near-edge"), order.find("hunted"));
  EXPECT_LT(order.find("hunted"), order.find("solid_angle"));
  EXPECT_LT(order.find("solid_angle"), order.find("torus"));
}

// The closed form, which declines wherever a point lies below the plane z = 0.
const RegisterEvaluation declining{
    single_family("triangle.single_layer", "declining_below",
                  {.description = "says that it could not", .role = Role::Foreign}, false, [](Evaluation& evaluation) {
                    const Evaluation good = evaluation_named("triangle.single_layer", "closed_form");
                    evaluation.set_point<double>([good](const Query<double>& query, Result<double>& result) {
                      good(query, result);
                      result.converged = query.point[2] >= 0;
                    });
                  })};

reports::WorstLine stored(const char* evaluation, double height) {
  reports::WorstLine line;
  static_cast<RowKey&>(line) = key("truth", evaluation, "hunted");
  line.unit = "conditioned";
  line.worst.corners = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  line.worst.point = {0.25, 0.25, height};
  line.worst.asked = 0;
  return line;
}

TEST(replay, tells_declined_from_measured) {
  const auto above = stored("declining_below", 0.5), below = stored("declining_below", -0.5);
  const Finding measured = replay(above, above.worst, Triangulation::Shortest);
  EXPECT_EQ(measured.status, Finding::Status::Measured);
  EXPECT_LT(measured.error, 64);
  EXPECT_EQ(replay(below, below.worst, Triangulation::Shortest).status, Finding::Status::Declined);
}

TEST(stored_cases, have_relative_errors_and_count_what_is_declined) {
  std::string text;
  for (const double height : {0.5, -0.5, 1.0 / 3, -1.0 / 3})
    text += reports::worst_line(stored("declining_below", height)) + "\n";
  const auto rows = replay_stored(text, "cases", "*", "*", 2);
  ASSERT_EQ(rows.size(), 1u);
  EXPECT_EQ(rows[0].samples, 2u);
  EXPECT_EQ(rows[0].declined, 2u);
  EXPECT_EQ(rows[0].without_truth, 0u);
  EXPECT_GT(rows[0].max_relative, 0);
  EXPECT_LT(rows[0].max_relative, 1e-14);
  EXPECT_EQ(rows[0].worst.size(), 2u);
  EXPECT_NE(rows[0].verdict, Verdict::Broken);
}

}  // namespace
}  // namespace cageproof::validation
