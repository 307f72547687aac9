// SPDX-License-Identifier: MIT
// Libraries and programs that only have coordinates of whole cages: measured, and what they do wrong is found.
#include "cageproof/core/input_error.h"
#include "cageproof/judge/certificate.h"
#include "cageproof/judge/templates.h"
#include "cageproof/judge/whole_cage.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>

namespace cageproof::judge {
namespace {

constexpr std::string_view kKind = "mean_value";

Limits cage_limits() {
  Limits found;
  found.host = {JUDGE_TEST_HOST};
  found.seconds = 5;
  return found;
}

// A tetrahedron, at five points; the third has the x that the library waits for.
std::vector<Asked> five() {
  std::vector<Asked> asked;
  for (const double x : {0.125, 0.25, 0.5, 0.375, 0.625}) {
    asked.push_back(asked_of({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
                              {{{0, 2, 1, -1}}, {{0, 1, 3, -1}}, {{1, 2, 3, -1}}, {{2, 0, 3, -1}}},
                              {{x, 0.125, 0.125}}}));
    asked.back().coordinates = 4;
  }
  return asked;
}

struct Found {
  std::vector<Answer> answers;
  std::vector<Incident> incidents;
};

Found library_that(const std::string& what) {
  setenv("HOSTILE", what.c_str(), 1);
  Found found;
  ForeignCode code(JUDGED_LIBRARIES "/cage.so", cage_limits());
  found.answers = code.ask({.kind = kKind}, five());
  code.finish();
  found.incidents = code.incidents();
  unsetenv("HOSTILE");
  return found;
}

void expect_only_third(const std::string& what, Answer::Status status, const std::string& kind,
                       const std::string& part) {
  const Found found = library_that(what);
  for (std::size_t i = 0; i < found.answers.size(); ++i)
    EXPECT_EQ(found.answers[i].status, i == 2 ? status : Answer::Status::Given) << what << i;
  ASSERT_EQ(found.incidents.size(), kind.empty() ? 0U : 1U) << what;
  if (kind.empty()) return;
  EXPECT_EQ(found.incidents[0].kind, kind);
  EXPECT_EQ(found.incidents[0].formula, kKind);
  EXPECT_NE(found.incidents[0].text.find(part), std::string::npos) << found.incidents[0].text;
  EXPECT_NE(found.incidents[0].input.find("\"points\":[[\"0x1p-1\","), std::string::npos) << found.incidents[0].input;
}

TEST(foreign_cage, library_gives_coordinates) {
  const Found found = library_that("nothing");
  EXPECT_TRUE(found.incidents.empty());
  for (const Answer& answer : found.answers) {
    ASSERT_EQ(answer.status, Answer::Status::Given);
    // The coordinates reproduce the point: barycentric ones, since it is a tetrahedron.
    ASSERT_EQ(answer.tensors[0].size(), 4U);
    EXPECT_NEAR(answer.tensors[0][2], 0.125, 1e-15);
  }
}

TEST(foreign_cage, harm_that_a_library_does_is_found_with_its_input) {
  using enum Answer::Status;
  expect_only_third("crash", Failed, "crash", "signal 11");
  expect_only_third("decline", Declined, "", "");
  expect_only_third("read beyond", Failed, "crash", "`faces`");
  expect_only_third("write beyond", Failed, "crash", "`coordinates`");
  expect_only_third("change input", Given, "changed input", "it changed the cage or points");
  expect_only_third("short", Given, "short answer", "unset");
}

TEST(foreign_cage, library_without_elements_has_no_formula) {
  ForeignCode code(JUDGED_LIBRARIES "/cage.so", cage_limits());
  EXPECT_EQ(code.order_of(formula_named("triangle.mean_value")), -1);
  EXPECT_THROW(register_foreign_code(std::make_shared<ForeignCode>(JUDGED_LIBRARIES "/cage.so", cage_limits()),
                                     "cage_only", "*"),
               InputError);
}

TEST(foreign_cage, library_without_cages_declines_them) {
  ForeignCode code(JUDGED_LIBRARIES "/mine.so", cage_limits());
  EXPECT_EQ(code.ask({.kind = kKind}, five()).front().status, Answer::Status::Declined);
  const auto campaign = run_cage_campaign(code, kKind, "mine", {.samples = 3, .regimes = "inside"});
  EXPECT_EQ(campaign.rows.at(0).declined, 3);
  EXPECT_EQ(campaign.rows.at(0).samples, 0);
}

TEST(foreign_cage, errors_are_those_of_the_code) {
  ForeignCode code(JUDGED_LIBRARIES "/cage.so", cage_limits());
  const SubjectCampaign campaign = run_cage_campaign(code, kKind, "mine", {.samples = 20});
  ASSERT_EQ(campaign.rows.size(), cage_regimes().size());
  for (const CampaignRow& row : campaign.rows) {
    EXPECT_EQ(row.samples, 20) << row.regime;
    EXPECT_EQ(row.nonfinite, 0) << row.regime;
    // Next to edges Ju et al.'s form loses digits; nowhere all of them.
    EXPECT_LT(row.relative.error, row.regime.starts_with("near-") ? 1e-2
                                  : row.regime == "offset"        ? 1e-9
                                                                  : 1e-12)
        << row.regime;
    if (!row.regime.starts_with("on-")) EXPECT_GT(row.relative.error, 0) << row.regime;
  }
  EXPECT_EQ(campaign.times.size(), 3U);
}

TEST(foreign_cage, convention_is_undone_before_errors_are_measured) {
  ForeignCode code(JUDGED_LIBRARIES "/cage.so", cage_limits());
  const CageConvention halves{{{0, 0.5, 0}}, ""};
  const auto campaign = run_cage_campaign(code, kKind, "mine", {.samples = 3, .regimes = "inside"}, halves);
  EXPECT_NEAR(campaign.rows.at(0).relative.median, 1, 1e-12);
}

TEST(foreign_cage, wrong_numbers_on_the_cage_that_are_no_limit_are_a_defect) {
  ForeignCode code(JUDGED_LIBRARIES "/cage.so", cage_limits());
  const auto asked = [&](const std::optional<CageConvention>& convention) {
    return findings_of({run_cage_campaign(code, kKind, "mine", {.samples = 3, .regimes = "on-edge"}, convention)}, {});
  };
  EXPECT_TRUE(asked(std::nullopt).empty());
  const auto found = asked(CageConvention{{{0, 0.5, 0}}, ""});
  ASSERT_FALSE(found.empty());
  EXPECT_EQ(found[0].kind, "on the element");
  EXPECT_TRUE(found[0].is_defect);
}

TEST(foreign_cage, threshold_is_named) {
  setenv("HOSTILE", "threshold", 1);
  ForeignCode code(JUDGED_LIBRARIES "/cage.so", cage_limits());
  const CageVerdict verdict = judge_whole_cage(whole_cage_function(code, kKind), kKind);
  unsetenv("HOSTILE");
  ASSERT_EQ(verdict.findings.size(), 1U);
  EXPECT_EQ(verdict.findings[0].defect->key, "absolute_threshold");
  const auto named = named_findings(verdict, kKind);
  EXPECT_NE(named.at(0).text.find("docs/defects.md#absolute_threshold"), std::string::npos) << named.at(0).text;
  EXPECT_NE(named.at(0).input.find("{\"kind\":\"mean_value\",\"vertices\":"), std::string::npos) << named.at(0).input;
}

TEST(foreign_cage, kinds_that_are_no_sums_of_numbers_are_refused) {
  for (const std::string_view kind : {"nothing", "somigliana", "quad_mean_value", "harmonic"})
    EXPECT_THROW(require_judged_kind(kind), InputError) << kind;
  for (const std::string_view kind : {"mean_value", "green", "biharmonic", "maximum_entropy"})
    EXPECT_NO_THROW(require_judged_kind(kind));
}

}  // namespace
}  // namespace cageproof::judge
