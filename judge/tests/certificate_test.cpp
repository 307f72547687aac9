// SPDX-License-Identifier: MIT
// A certificate's findings from errors, incidents and promises.
#include "cageproof/core/input_error.h"
#include "cageproof/judge/certificate.h"
#include "cageproof/judge/templates.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <cstdlib>

namespace cageproof::judge {
namespace {

Limits limits() {
  Limits found;
  found.host = {JUDGE_TEST_HOST};
  return found;
}

const CampaignRow& row(const SubjectCampaign& campaign, const std::string& regime) {
  for (const CampaignRow& one : campaign.rows)
    if (one.regime == regime) return one;
  throw InputError("no such row");
}

SubjectCampaign campaign_of(ForeignCode& code, const std::string& formula) {
  ElementCampaignOptions options;
  options.samples = 40;
  return run_element_campaign(code, formula_named(formula), "mine", options);
}

bool has(const std::vector<CodeFinding>& findings, const std::string& kind, bool is_defect) {
  return std::ranges::any_of(findings, [&](const auto& f) { return f.kind == kind && f.is_defect == is_defect; });
}

TEST(certificate, sound_example_is_clean) {
  ForeignCode code(JUDGED_LIBRARIES "/mine.so", limits());
  EXPECT_EQ(code.about(), "winding angle by the arctangent, 1.0");
  ASSERT_EQ(code.files().size(), 1U);
  EXPECT_EQ(code.files()[0].sha256.size(), 64U);
  const SubjectCampaign campaign = campaign_of(code, "segment.winding_angle");
  EXPECT_EQ(row(campaign, "generic").samples, 40);
  EXPECT_LT(row(campaign, "generic").conditioned.error, 2);
  EXPECT_LT(row(campaign, "near-vertex").conditioned.error, 4);
  EXPECT_LT(row(campaign, "far").relative.error, 1e-13);
  ASSERT_FALSE(campaign.times.empty());
  EXPECT_EQ(campaign.times[0].evaluation, "mine");
  code.finish();
  const auto findings = findings_of({campaign}, code.incidents());
  for (const CodeFinding& finding : findings) EXPECT_FALSE(finding.is_defect) << finding.text;
  Certificate certificate;
  certificate.formulas = {campaign};
  certificate.findings = findings;
  EXPECT_FALSE(certificate.has_defects());
  EXPECT_FALSE(certificate.is_undecided());
  const auto json = nlohmann::json::parse(json_of(certificate));
  EXPECT_EQ(json["verdict"], "clean");
  EXPECT_EQ(json["formulas"][0]["rows"][0]["relative"]["input"]["element"].size(), 2U);
  EXPECT_NE(markdown_of(certificate).find("| generic | value | 40 |"), std::string::npos);
}

TEST(certificate, promise_is_kept_or_broken_where_it_is) {
  ForeignCode code(JUDGED_LIBRARIES "/mine.so", limits());
  ElementCampaignOptions options;
  options.samples = 20;
  options.regimes = "generic,far";
  const std::vector<SubjectCampaign> campaigns{
      run_element_campaign(code, formula_named("segment.winding_angle"), "mine", options)};
  using Measure = OwnPromise::Measure;
  for (const Measure measure : {Measure::Relative, Measure::Absolute, Measure::Conditioned}) {
    EXPECT_TRUE(judged_promise({measure, 1e-13, true, {}}, campaigns, false).is_kept) << name_of(measure);
    // Far away values are small, and so are their absolute errors.
    const double bound = measure == Measure::Absolute ? 1e-17 : 1e-18;
    const OwnPromise broken = judged_promise({measure, bound, true, {}}, campaigns, false);
    EXPECT_FALSE(broken.is_kept) << name_of(measure);
    EXPECT_EQ(broken.broken.size(), measure == Measure::Absolute ? 1U : 2U) << broken.broken.back();
  }
}

TEST(certificate, sevens_are_other_numbers_and_a_crash_is_an_incident) {
  setenv("HOSTILE", "crash", 1);
  ForeignCode code(JUDGED_LIBRARIES "/hostile.so", limits());
  ElementCampaignOptions options;
  options.samples = 20;
  options.regimes = "generic,aligned";
  const SubjectCampaign campaign = run_element_campaign(code, formula_named("triangle.single_layer"), "mine", options);
  unsetenv("HOSTILE");
  code.finish();
  const auto findings = findings_of({campaign}, code.incidents());
  EXPECT_TRUE(has(findings, "other numbers", true));
  EXPECT_FALSE(has(findings, "inaccurate", true));
}

TEST(certificate, not_a_number_is_a_defect_but_not_at_the_ends_of_the_range) {
  SubjectCampaign campaign{"triangle.single_layer", false, 0, {}, {}};
  CampaignRow one;
  one.samples = 10;
  one.nonfinite = 2;
  one.regime = "near-edge";
  campaign.rows = {one};
  EXPECT_TRUE(has(findings_of({campaign}, {}), "not finite", true));
  campaign.rows[0].regime = "scaled";
  EXPECT_TRUE(has(findings_of({campaign}, {}), "range", false));
}

TEST(certificate, eight_lost_digits_are_a_defect_off_the_element_only) {
  SubjectCampaign campaign{"triangle.single_layer", false, 0, {}, {}};
  CampaignRow one;
  one.samples = 10;
  one.regime = "near-edge";
  one.beside.error = 1e7;
  campaign.rows = {one};
  EXPECT_TRUE(findings_of({campaign}, {}).empty());
  campaign.rows[0].beside.error = 1e8;
  EXPECT_TRUE(has(findings_of({campaign}, {}), "inaccurate", true));
  campaign.rows[0].regime = "on-edge";
  EXPECT_TRUE(has(findings_of({campaign}, {}), "on the element", false));
}

TEST(certificate, hash_is_that_of_the_standard) {
  // FIPS 180-4 gives these of "abc" and of nothing.
  ForeignCode code("env printf '{\"formulas\":{}}\\n' " JUDGED_PROGRAMS "/abc.txt", limits());
  ASSERT_EQ(code.files().size(), 2U);
  EXPECT_EQ(code.files()[1].sha256, "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
}

TEST(certificate, digits_are_counted_from_relative_errors) {
  EXPECT_EQ(digits_of(2), 0);
  EXPECT_EQ(digits_of(std::nan("")), 0);
  EXPECT_NEAR(digits_of(1e-5), 5, 1e-9);
  EXPECT_EQ(digits_of(0), 17);
}

TEST(register_code, says_what_it_lacks) {
  EXPECT_THROW(name_and_what("mine"), InputError);
  EXPECT_THROW(name_and_what("=x"), InputError);
  EXPECT_EQ(name_and_what("mine=a b=c").second, "a b=c");
  const auto code = std::make_shared<ForeignCode>(JUDGED_LIBRARIES "/mine.so", limits());
  EXPECT_THROW(register_foreign_code(code, "mine", "triangle.*"), InputError);
  EXPECT_EQ(register_foreign_code(code, "mine", "*"), std::vector<std::string>{"segment.winding_angle"});
}

TEST(register_code, gives_the_codes_numbers_in_blocks_and_alone) {
  const auto code = std::make_shared<ForeignCode>(JUDGED_LIBRARIES "/mine.so", limits());
  register_foreign_code(code, "winding", "segment.winding_angle");
  const Evaluation evaluation = evaluation_named("segment.winding_angle", "winding");
  const std::vector<Vec3<double>> corners{{0, 0, 0}, {1, 0, 0}};
  Result<double> result;
  evaluation(Query<double>{corners, {0.5, 0.5, 0}, 0, {}, false}, result);
  EXPECT_DOUBLE_EQ(result.value[0], std::atan2(0.5, 0.));
}

TEST(templates, exist_for_elements_and_cages) {
  EXPECT_EQ(template_languages().size(), 4U);
  EXPECT_EQ(template_files("c").size(), 2U);
  EXPECT_EQ(template_files("python")[0].first, "mine.py");
  EXPECT_EQ(template_files("python-cage")[0].first, "mine_cage.py");
  EXPECT_NE(template_files("c", "triangle.kelvin_traction")[1].second.find("values + 27 * p"), std::string::npos);
  EXPECT_THROW(template_files("c", "mean_value"), InputError);
}

}  // namespace
}  // namespace cageproof::judge
