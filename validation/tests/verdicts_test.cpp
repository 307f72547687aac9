// SPDX-License-Identifier: MIT
// The one way from a tally to a judged row, and what replay makes of samples that were not measured.
#include "cageproof/validation/verdicts.h"

#include "cageproof/core/input_error.h"
#include "cageproof/reports/worst_file.h"
#include "cageproof/validation/hunt.h"
#include "cageproof/validation/replay.h"
#include "cageproof/validation/stored_cases.h"

#include <gtest/gtest.h>

namespace cageproof::validation {
namespace {

RowKey key(const char* check, const char* evaluation, const char* regime, int order = 0) {
  return {RowKey::Section::Element, "triangle.single_layer", evaluation, "double", regime, check, "", order};
}

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
  return found;
}

TEST(rows, hold_every_figure_of_their_tally) {
  Tally found = tally(3);
  found.merge(tally(50, 2));
  found.declined = 4;
  const ResultRow row = row_of(key("truth", "closed_form", "on-face"), found);
  EXPECT_EQ(static_cast<const RowKey&>(row), key("truth", "closed_form", "on-face"));
  EXPECT_EQ(row.unit, "conditioned");
  EXPECT_EQ(row.samples, 2u);
  EXPECT_EQ(row.max, 50);
  EXPECT_EQ(row.p999, 50);
  EXPECT_EQ(row.median, found.errors.median());
  EXPECT_EQ(row.max_relative, 50 * 1e-16);
  EXPECT_EQ(row.without_truth, 2u);
  EXPECT_EQ(row.declined, 4u);
  EXPECT_EQ(row.worst.size(), 2u);
  EXPECT_EQ(row.histogram.size(), found.errors.counts().size());
  EXPECT_EQ(*row.bound, 64);
  EXPECT_EQ(row.verdict, Verdict::Kept);
}

TEST(rows, are_broken_where_a_truth_must_exist_and_does_not) {
  EXPECT_EQ(row_of(key("truth", "closed_form", "near-edge"), tally(3, 1)).verdict, Verdict::Broken);
  EXPECT_EQ(row_of(key("truth", "closed_form", "on-edge"), tally(3, 1)).verdict, Verdict::Kept);
  EXPECT_EQ(row_of(key("scaling", "closed_form", "near-edge"), tally(3, 1)).verdict, Verdict::Kept);
  Tally declined = tally(-1);
  declined.declined = 9;
  EXPECT_EQ(row_of(key("truth", "closed_form", "near-edge"), declined).verdict, Verdict::NotPromised);
}

TEST(rows, are_withdrawn_where_the_integral_confirms_nothing) {
  std::map<RowKey, Tally> tallies;
  RowKey gate = key("integral", "closed_form", "near-edge");
  gate.scalar = "mp100";
  tallies[gate] = tally(1);
  tallies[key("truth", "closed_form", "near-edge")] = tally(3);
  tallies[key("truth", "closed_form", "near-face")] = tally(3);
  const Judged found = judged(tallies);
  ASSERT_EQ(found.notes.size(), 1u);
  for (const ResultRow& row : found.rows)
    if (row.check == "truth") {
      EXPECT_EQ(row.verdict, row.regime == "near-edge" ? Verdict::NotPromised : Verdict::Kept) << row.regime;
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
  for (const ResultRow& row : judged(tallies).rows)
    order += row.subject + " " + row.regime + " " + row.check + " " + row.evaluation + "\n";
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
