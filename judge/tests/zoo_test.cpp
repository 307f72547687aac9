// SPDX-License-Identifier: MIT
// Each member of the zoo is named, nothing else is claimed of it, and what is sound is clean.
#include "zoo_evaluation.h"

#include "cageproof/judge/verdict.h"

#include <gtest/gtest.h>

extern "C" {
#define CAGEPROOF_ZOO(name) void zoo_##name(const zoo_call*);
#include "zoo_members.inc"
#undef CAGEPROOF_ZOO
}

namespace cageproof::judge {
namespace {

struct Member {
  const char* name;
  ZooFunction function;
  const char* formula;
  const char* defect;    // "" for sound ones
  const char* sentence;  // of the convention; "" where none is demanded
  int max_order = 1;
};

void PrintTo(const Member& member, std::ostream* out) { *out << member.name << " of " << member.formula; }

std::string text_of(const Verdict& verdict) {
  std::ostringstream text;
  text.precision(17);
  text << verdict.convention_sentence << '\n';
  for (const FoundDefect& f : verdict.findings) {
    text << f.defect->key << " (order " << f.order << ", " << f.cases << " cases): " << f.evidence << "\n ";
    for (const auto& corner : f.input.corners) text << " [" << corner.transpose() << ']';
    text << " at " << f.input.point.transpose() << "\n  ours";
    for (const double x : f.ours) text << ' ' << x;
    text << "\n  theirs";
    for (const double x : f.theirs) text << ' ' << x;
    text << '\n';
  }
  return text.str();
}

class Zoo : public testing::TestWithParam<Member> {};

TEST_P(Zoo, is_named_and_nothing_else_is_claimed) {
  const Member& member = GetParam();
  const Verdict verdict = judge(zoo_evaluation(member.formula, member.name, member.function, member.max_order), {});
  if (std::getenv("CAGEPROOF_ZOO_TEXT") != nullptr) std::cout << text_of(verdict);
  std::string found;
  for (const FoundDefect& finding : verdict.findings)
    found += (found.empty() ? "" : " ") + std::string(finding.defect->key);
  EXPECT_EQ(found, member.defect) << text_of(verdict);
  if (*member.sentence != 0) EXPECT_EQ(verdict.convention_sentence, member.sentence);
}

#define MEMBER(name, ...) \
  Member { #name, zoo_##name, __VA_ARGS__ }
constexpr const char* kSolid = "triangle.solid_angle";
constexpr const char* kSingle = "triangle.single_layer";
constexpr const char* kDouble = "triangle.double_layer";
constexpr const char* kMean = "triangle.mean_value";
constexpr const char* kKelvin = "triangle.kelvin_displacement";
constexpr const char* kOurs = "yours is ours";
constexpr const char* kNone = "none fits all generic samples, so that yours is taken for ours";

INSTANTIATE_TEST_SUITE_P(defects, Zoo,
                         testing::Values(MEMBER(writes_past_output, kDouble, "writes_past_output", ""),
                                         MEMBER(non_deterministic, kSingle, "non_deterministic", ""),
                                         MEMBER(appended_output, kDouble, "appended_output", ""),
                                         MEMBER(uninitialised_output, kDouble, "uninitialised_output", ""),
                                         MEMBER(reads_past_input, kSingle, "reads_past_input", ""),
                                         MEMBER(order_of_calls, kSolid, "order_of_calls", ""),
                                         MEMBER(state_between_calls, kDouble, "state_between_calls", ""),
                                         MEMBER(stale_cache, kSingle, "state_between_calls", ""),
                                         MEMBER(differs_between_threads, kSolid, "differs_between_threads", ""),
                                         MEMBER(ignored_parameter, kKelvin, "ignored_parameter", kOurs),
                                         MEMBER(quadrature, kSolid, "quadrature_near", ""),
                                         MEMBER(right_after_normalising, kMean, "right_after_normalising", kNone, 0),
                                         MEMBER(sum_made_right, kDouble, "sum_made_right", kNone, 0),
                                         MEMBER(gradient_only_in_sums, kSolid, "gradient_only_in_sums", kOurs),
                                         MEMBER(absolute_threshold, kSolid, "absolute_threshold", kOurs),
                                         MEMBER(absolute_threshold, kDouble, "absolute_threshold", kOurs),
                                         MEMBER(absolute_distance, kSingle, "absolute_threshold", kOurs),
                                         MEMBER(absolute_distance, "segment.single_layer", "absolute_threshold", kOurs),
                                         MEMBER(absolute_distance, "segment.mean_value", "absolute_threshold", kOurs),
                                         MEMBER(log_next_to_edge, kSingle, "log_next_to_edge", kOurs),
                                         MEMBER(nan_at_vertex, kSingle, "nan_at_vertex", kOurs),
                                         MEMBER(nan_at_vertex, "segment.single_layer", "nan_at_vertex", kOurs),
                                         MEMBER(nan_at_edge, kSingle, "nan_at_edge", kOurs),
                                         MEMBER(nan_at_face, kSingle, "nan_at_face", kOurs),
                                         MEMBER(nan_at_face, kDouble, "nan_at_face", kOurs),
                                         MEMBER(vertex_for_edge, kSingle, "vertex_for_edge", kOurs),
                                         MEMBER(plane_branch, kSolid, "plane_branch", kOurs),
                                         MEMBER(zero_on_face, kSolid, "zero_on_face", kOurs),
                                         MEMBER(zero_on_face, kDouble, "zero_on_face", kOurs),
                                         MEMBER(projected_into_face, kSolid, "projected_into_face", kOurs),
                                         MEMBER(far_cancellation, kSolid, "far_cancellation", kOurs),
                                         MEMBER(sliver_cancellation, kSingle, "sliver_cancellation", kOurs),
                                         MEMBER(plane_cancellation, kSolid, "plane_cancellation", kOurs),
                                         MEMBER(few_digits, kDouble, "few_digits", kNone),
                                         MEMBER(wrong_gradient, kSingle, "wrong_gradient", kOurs),
                                         MEMBER(outer_limit_on_face, kSolid, "outer_limit_on_face", kOurs),
                                         MEMBER(wrong_values, kSingle, "wrong_values", kNone)));

INSTANTIATE_TEST_SUITE_P(
    sound_ones, Zoo,
    testing::Values(
        MEMBER(sound, kSolid, "", kOurs), MEMBER(sound, kSingle, "", kOurs), MEMBER(sound, kDouble, "", kOurs),
        MEMBER(sound, kMean, "", kOurs), MEMBER(sound, kKelvin, "", kOurs),
        MEMBER(sound, "segment.single_layer", "", kOurs), MEMBER(sound, "segment.double_layer", "", kOurs),
        MEMBER(sound, "segment.mean_value", "", kOurs),
        MEMBER(minus_over_four_pi, kSolid, "",
               "yours is ours times -1/(4 pi) (the sign of the kernel, or point minus element)"),
        MEMBER(minus_over_four_pi, kSingle, "", "yours is ours times -1/(4 pi) (the sign of the fundamental solution)"),
        MEMBER(reversed, kDouble, "", "yours is ours, with corners the other way round, so that normals point inward"),
        MEMBER(reversed, "segment.double_layer", "",
               "yours is ours, with corners the other way round, so that normals point inward"),
        MEMBER(other_corner_order, kDouble, "", "yours is ours, with corners in the order 2, 3, 1"),
        MEMBER(transposed, "triangle.kelvin_traction", "", "yours is ours, with rows and columns swapped", 0),
        MEMBER(by_the_element, kSingle, "",
               "yours is ours, and derivatives by the element's position instead of the point's"),
        MEMBER(normalised, kMean, "", "yours is ours, divided by the sum over the corners", 0),
        MEMBER(without_modulus, kKelvin, "", "yours is ours times mu"),
        MEMBER(other_formula, kMean, "", "yours is triangle.double_layer instead of triangle.mean_value")));

// Evaluations of the catalogue through the same door.
TEST(judged, the_suites_own_evaluations_are_clean) {
  for (const char* name : {"plain", "closed_form", "hybrid", "accurate"})
    for (const char* formula : {kSolid, kSingle, "segment.double_layer"}) {
      const Verdict verdict = judge(evaluation_named(formula, name), {});
      EXPECT_TRUE(verdict.findings.empty()) << formula << ' ' << name << '\n' << text_of(verdict);
      EXPECT_EQ(verdict.convention_sentence, kOurs);
    }
}

// Other inputs, with roundings off edges and faces where several defects look alike.
TEST(judged, other_seeds_find_the_same) {
  constexpr std::array<std::pair<const char*, ZooFunction>, 3> members{{{"nan_at_face", &zoo_nan_at_face},
                                                                        {"nan_at_edge", &zoo_nan_at_edge},
                                                                        {"vertex_for_edge", &zoo_vertex_for_edge}}};
  for (const std::uint64_t seed : {2, 5})
    for (const auto& [key, function] : members) {
      const Verdict verdict = judge(zoo_evaluation(kSingle, key, function), {.seed = seed});
      ASSERT_EQ(verdict.findings.size(), 1U) << seed << ' ' << text_of(verdict);
      EXPECT_EQ(verdict.findings[0].defect->key, key);
    }
}

// Its values are those of the published form, with that one's defects.
TEST(judged, the_curl_form_is_right_in_sums_only) {
  const Verdict verdict = judge(evaluation_named(kDouble, "curl-form"), {});
  ASSERT_EQ(verdict.findings.size(), 3U) << text_of(verdict);
  EXPECT_EQ(verdict.findings[0].defect->key, "gradient_only_in_sums");
}

TEST(judged, an_edge_form_with_the_papers_logarithm_loses_digits_next_to_edges_and_far_away) {
  const Verdict verdict = judge(evaluation_named(kSingle, "published"), {});
  ASSERT_EQ(verdict.findings.size(), 2U) << text_of(verdict);
  EXPECT_EQ(verdict.findings[0].defect->key, "log_next_to_edge");
  EXPECT_EQ(verdict.findings[1].defect->key, "far_cancellation");
}

// Sixteen characters or fewer a coordinate would be doubles as they come; a shrunk input is plain.
TEST(judged, inputs_are_shrunk_to_the_unit_triangle) {
  const Verdict verdict = judge(zoo_evaluation(kSolid, "projected", zoo_projected_into_face), {});
  ASSERT_EQ(verdict.findings.size(), 1U);
  const validation::Sample& input = verdict.findings[0].input;
  EXPECT_EQ(input.corners, (std::vector<Vec3<double>>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}));
  EXPECT_LT(std::abs(input.point[2]), 1e-6);
  const auto again =
      validation::evaluate<double>(zoo_evaluation(kSolid, "projected", zoo_projected_into_face), input, 1);
  EXPECT_EQ(again.value, verdict.findings[0].theirs);
  EXPECT_GT(std::abs(verdict.findings[0].theirs[0] - verdict.findings[0].ours[0]), 1e-10);
}

TEST(judged, a_gauss_rule_is_named_and_nothing_else) {
  for (const char* formula : {kDouble, "segment.single_layer"}) {
    const Verdict verdict = judge(evaluation_named(formula, "gauss-64"), {});
    ASSERT_EQ(verdict.findings.size(), 1U) << formula << '\n' << text_of(verdict);
    EXPECT_EQ(verdict.findings[0].defect->key, "quadrature_near");
  }
}

}  // namespace
}  // namespace cageproof::judge
