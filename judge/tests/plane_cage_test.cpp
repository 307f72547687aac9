// SPDX-License-Identifier: MIT
// Whole cages in the plane: polygons as a library and a program get them, regimes, conventions, named defects.
#include "cageproof/core/coordinates/coordinates.h"
#include "cageproof/core/input_error.h"
#include "cageproof/judge/certificate.h"
#include "cageproof/judge/whole_cage.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numbers>

namespace cageproof::judge {
namespace {

constexpr std::string_view kKind = "mean_value";

Limits plane_limits() {
  Limits found;
  found.host = {JUDGE_TEST_HOST};
  found.seconds = 5;
  return found;
}

CageRequest triangle(double x) {
  return {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, -1}, {1, 2, -1}, {2, 0, -1}}, {{x, 0.25, 0}}, 2};
}

std::string keys_in(const CageVerdict& verdict) {
  std::string found;
  for (const CageFinding& finding : verdict.findings)
    found += (found.empty() ? "" : " ") + std::string(finding.defect->key);
  return found;
}

// By the suite: the blocks one after another.
std::vector<double> suite(const CageRequest& q, std::string_view kind) {
  const CageCoordinates coordinates(q.cage(), coordinate_kind_named(kind), CoordinateOptions{"hybrid"});
  std::vector<double> values;
  for (const auto& block : coordinates.at<double>(q.points[0], 0))
    values.insert(values.end(), block.value.begin(), block.value.end());
  return values;
}

TEST(plane_cage, library_gets_segments_and_points_of_two_coordinates) {
  ForeignCode code(JUDGED_LIBRARIES "/plane.so", plane_limits());
  Asked asked = asked_of(triangle(0.5));
  EXPECT_EQ(asked.corners, (std::vector<double>{0, 0, 1, 0, 0, 1}));
  EXPECT_EQ(asked.faces, (std::vector<int>{0, 1, 1, 2, 2, 0}));
  EXPECT_EQ(asked.points, (std::vector<double>{0.5, 0.25}));
  asked.coordinates = 3;
  const Answer answer = code.ask({.kind = kKind}, {&asked, 1}).front();
  ASSERT_EQ(answer.status, Answer::Status::Given);
  EXPECT_NEAR(answer.tensors[0].at(1), 0.5, 1e-15);
  EXPECT_NEAR(answer.tensors[0].at(2), 0.25, 1e-15);
  EXPECT_EQ(exact_line(Request{.kind = kKind}, asked, 0),
            R"({"kind":"mean_value","vertices":[["0x0p+0","0x0p+0"],["0x1p+0","0x0p+0"],["0x0p+0","0x1p+0"]],)"
            R"("faces":[[0,1],[1,2],[2,0]],"points":[["0x1p-1","0x1p-2"]]})");
}

TEST(plane_cage, library_that_leaves_its_arrays_is_found) {
  setenv("HOSTILE", "read beyond", 1);
  ForeignCode code(JUDGED_LIBRARIES "/plane.so", plane_limits());
  Asked asked = asked_of(triangle(0.5));
  asked.coordinates = 3;
  EXPECT_EQ(code.ask({.kind = kKind}, {&asked, 1}).front().status, Answer::Status::Failed);
  unsetenv("HOSTILE");
  ASSERT_EQ(code.incidents().size(), 1U);
  EXPECT_NE(code.incidents()[0].text.find("`faces`"), std::string::npos) << code.incidents()[0].text;
}

// A library has one dimension, or both; the other is declined.
TEST(plane_cage, dimension_that_a_library_lacks_is_declined) {
  ForeignCode plane(JUDGED_LIBRARIES "/plane.so", plane_limits());
  ForeignCode space(JUDGED_LIBRARIES "/cage.so", plane_limits());
  EXPECT_EQ(run_cage_campaign(plane, kKind, "mine", {.samples = 3, .regimes = "inside"}).rows.at(0).declined, 3);
  EXPECT_EQ(
      run_cage_campaign(space, kKind, "mine", {.samples = 3, .regimes = "inside"}, std::nullopt, 2).rows.at(0).declined,
      3);
}

TEST(plane_cage, sound_code_is_clean_and_every_regime_has_samples) {
  ForeignCode code(JUDGED_LIBRARIES "/plane.so", plane_limits());
  const CageVerdict verdict = judge_whole_cage(whole_cage_function(code, kKind), kKind, 2);
  EXPECT_EQ(keys_in(verdict), "");
  ASSERT_TRUE(verdict.convention);
  EXPECT_TRUE(verdict.convention->is_ours());
  const SubjectCampaign campaign = run_cage_campaign(code, kKind, "mine", {.samples = 21}, verdict.convention, 2);
  EXPECT_EQ(campaign.dimension, 2);
  ASSERT_EQ(campaign.rows.size(), cage_regimes(2).size());
  for (const CampaignRow& row : campaign.rows) {
    EXPECT_EQ(row.samples, 21) << row.regime;
    EXPECT_EQ(row.nonfinite, 0) << row.regime;
    // Far from the origin the rounding of the point is what a stable form loses.
    EXPECT_LT(row.conditioned.error, 64) << row.regime;
    if (!row.regime.starts_with("on-")) EXPECT_GT(row.relative.error, 0) << row.regime;
  }
  EXPECT_EQ(campaign.times.size(), 3U);
}

TEST(plane_cage, threshold_is_named) {
  setenv("HOSTILE", "threshold", 1);
  ForeignCode code(JUDGED_LIBRARIES "/plane.so", plane_limits());
  const CageVerdict verdict = judge_whole_cage(whole_cage_function(code, kKind), kKind, 2);
  unsetenv("HOSTILE");
  EXPECT_EQ(keys_in(verdict), "absolute_threshold");
  const auto named = named_findings(verdict, kKind);
  EXPECT_NE(named.at(0).input.find("\"faces\":[[0,1],"), std::string::npos) << named.at(0).input;
}

// Angles without their sign give the same numbers in convex polygons; the arrowhead has them wrong.
TEST(plane_cage, unsigned_angles_are_wrong_in_an_arrowhead) {
  const auto positive = [](const CageRequest& q) {
    std::vector<double> weights(q.vertices.size(), 0.0);
    double sum = 0;
    for (const auto& face : q.faces) {
      const auto from = static_cast<std::size_t>(face.vertices[0]), to = static_cast<std::size_t>(face.vertices[1]);
      const Vec3<double> a = q.vertices[from] - q.points[0], b = q.vertices[to] - q.points[0];
      if (a.norm() == 0 || b.norm() == 0) return suite(q, kKind);
      const double angle = std::acos(std::clamp(a.dot(b) / (a.norm() * b.norm()), -1., 1.));
      if (angle > 3.14) return suite(q, kKind);
      for (const auto& [v, d] : {std::pair(from, a.norm()), std::pair(to, b.norm())}) {
        weights[v] += std::tan(angle / 2) / d;
        sum += std::tan(angle / 2) / d;
      }
    }
    for (double& w : weights) w /= sum;
    return weights;
  };
  EXPECT_EQ(keys_in(judge_whole_cage(positive, kKind, 2)), "wrong_values");
}

TEST(plane_cage, kinds_of_the_suite_are_clean_in_both_dimensions) {
  for (const int dimension : {2, 3}) {
    for (const std::string_view kind : {"mean_value", "green", "biharmonic"}) {
      const CageVerdict verdict =
          judge_whole_cage([=](const CageRequest& q) { return suite(q, kind); }, kind, dimension);
      EXPECT_EQ(keys_in(verdict), "") << kind << dimension;
      ASSERT_TRUE(verdict.convention) << kind << dimension;
      EXPECT_EQ(verdict.convention->sentence, "yours is ours") << kind << dimension;
    }
  }
}

TEST(plane_cage, other_conventions_are_said_and_are_no_defects) {
  // Without 1/(2 pi); psi a mean over the segment, and first.
  const auto theirs = [](const CageRequest& q) {
    const std::vector<double> ours = suite(q, "green");
    std::vector<double> found;
    for (std::size_t s = 0; s < q.faces.size(); ++s) {
      const auto end = [&](int k) -> const Vec3<double>& {
        return q.vertices[static_cast<std::size_t>(q.faces[s].vertices[k])];
      };
      found.push_back(ours[q.vertices.size() + s] * 2 * std::numbers::pi / (end(1) - end(0)).norm());
    }
    for (std::size_t v = 0; v < q.vertices.size(); ++v) found.push_back(2 * std::numbers::pi * ours[v]);
    return found;
  };
  const CageVerdict verdict = judge_whole_cage(theirs, "green", 2);
  EXPECT_EQ(keys_in(verdict), "");
  ASSERT_TRUE(verdict.convention);
  EXPECT_EQ(verdict.convention->sentence,
            "yours is ours with psi times 2 pi divided by the segment's length, phi times 2 pi, the order psi, phi");
}

TEST(plane_cage, kinds_without_numbers_on_segments_are_refused) {
  for (const std::string_view kind : {"nothing", "somigliana", "quad_mean_value", "cauchy"})
    EXPECT_THROW(require_judged_kind(kind, 2), InputError) << kind;
}

}  // namespace
}  // namespace cageproof::judge
