// SPDX-License-Identifier: MIT
// Each defect of the zoo's implementations of whole cages is named, and nothing else.
#include "zoo.h"

#include "cageproof/judge/whole_cage.h"

#include "cageproof/core/coordinates/coordinates.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

extern "C" {
void zoo_cage_sound(const zoo_cage*);
void zoo_cage_chord_for_distance(const zoo_cage*);
void zoo_cage_state(const zoo_cage*);
void zoo_cage_sum_made_right(const zoo_cage*);
void zoo_cage_wrong_at_vertex(const zoo_cage*);
void zoo_cage_absolute_threshold(const zoo_cage*);
}

namespace cageproof::judge {
namespace {

using ZooCage = void (*)(const zoo_cage*);

std::vector<double> asked(ZooCage function, const CageRequest& q) {
  std::vector<double> coordinates(q.points.size() * q.vertices.size());
  std::vector<int> corners;
  for (const Face& face : q.faces) corners.insert(corners.end(), face.vertices.begin(), face.vertices.begin() + 3);
  const zoo_cage cage{q.vertices.data()->data(), q.vertices.size(), corners.data(),    q.faces.size(),
                      q.points.data()->data(),   q.points.size(),   coordinates.data()};
  function(&cage);
  return coordinates;
}

std::string found_in(const CageVerdict& verdict) {
  std::string found;
  for (const CageFinding& finding : verdict.findings)
    found += (found.empty() ? "" : " ") + std::string(finding.defect->key);
  return found;
}

std::string keys_of(ZooCage function) {
  return found_in(judge_whole_cage([=](const CageRequest& q) { return asked(function, q); }, "mean_value"));
}

TEST(whole_cage, each_defect_is_named_and_nothing_else) {
  EXPECT_EQ(keys_of(zoo_cage_sound), "");
  EXPECT_EQ(keys_of(zoo_cage_chord_for_distance), "chord_for_distance");
  EXPECT_EQ(keys_of(zoo_cage_state), "state_between_calls");
  EXPECT_EQ(keys_of(zoo_cage_sum_made_right), "sum_made_right");
  EXPECT_EQ(keys_of(zoo_cage_wrong_at_vertex), "wrong_on_cage");
  EXPECT_EQ(keys_of(zoo_cage_absolute_threshold), "absolute_threshold");
}

TEST(whole_cage, values_that_are_appended_have_the_wrong_size) {
  std::vector<double> all;
  const auto appended = [&](const CageRequest& q) {
    const auto more = asked(zoo_cage_sound, q);
    all.insert(all.end(), more.begin(), more.end());
    return all;
  };
  EXPECT_EQ(found_in(judge_whole_cage(appended, "mean_value")), "wrong_size");
}

TEST(whole_cage, constants_and_nan_are_no_state) {
  for (const double constant : {0.25, 0., HUGE_VAL, std::nan("")}) {
    const auto same = [=](const CageRequest& q) { return std::vector<double>(q.vertices.size(), constant); };
    EXPECT_EQ(found_in(judge_whole_cage(same, "mean_value")).find("state"), std::string::npos) << constant;
  }
}

TEST(whole_cage, state_is_shown_with_the_right_coordinates_of_its_question) {
  std::vector<double> last;
  const auto previous = [&](const CageRequest& q) {
    auto now = asked(zoo_cage_sound, q);
    if (last.size() != now.size()) last = now;
    std::swap(last, now);
    return now;
  };
  const CageVerdict verdict = judge_whole_cage(previous, "mean_value");
  ASSERT_EQ(found_in(verdict), "state_between_calls");
  const CageFinding& found = verdict.findings[0];
  const std::vector<double> right = asked(zoo_cage_sound, found.question);
  for (std::size_t i = 0; i < right.size(); ++i) EXPECT_NEAR(found.ours[i], right[i], 1e-14);
  EXPECT_NE(found.theirs, found.ours);
}

TEST(whole_cage, single_precision_is_few_digits) {
  const auto rounded = [](const CageRequest& q) {
    auto coordinates = asked(zoo_cage_sound, q);
    for (double& x : coordinates) x = static_cast<float>(x);
    return coordinates;
  };
  EXPECT_EQ(found_in(judge_whole_cage(rounded, "mean_value")), "few_digits");
}

TEST(whole_cage, values_without_their_sum_are_right_after_normalising) {
  const auto raw = [](const CageRequest& q) {
    auto weights = asked(zoo_cage_sound, q);
    for (double& w : weights) w *= 1 + (q.points[0] - q.vertices[0]).norm() / (q.vertices[1] - q.vertices[0]).norm();
    return weights;
  };
  EXPECT_EQ(found_in(judge_whole_cage(raw, "mean_value")), "right_after_normalising");
}

// Green coordinates by the suite: phi of the vertices, then psi of the faces.
std::vector<double> green(const CageRequest& q) {
  const CageCoordinates coordinates(q.cage(), coordinate_kind_named("green"), CoordinateOptions{"hybrid"});
  std::vector<double> values;
  for (const auto& block : coordinates.at<double>(q.points[0], 0))
    values.insert(values.end(), block.value.begin(), block.value.end());
  return values;
}

// As somebody has them whose faces are clockwise, whose potentials lack 1/(4 pi), whose psi is a mean over the face and
// stands first.
std::vector<double> other_green(const CageRequest& q) {
  const std::vector<double> ours = green(q);
  std::vector<double> theirs;
  for (std::size_t f = 0; f < q.faces.size(); ++f) {
    const auto corner = [&](int k) -> const Vec3<double>& {
      return q.vertices[static_cast<std::size_t>(q.faces[f].vertices[k])];
    };
    const double area = (corner(1) - corner(0)).cross(corner(2) - corner(0)).norm() / 2;
    theirs.push_back(ours[q.vertices.size() + f] * 4 * std::numbers::pi / area);
  }
  for (std::size_t v = 0; v < q.vertices.size(); ++v) theirs.push_back(-4 * std::numbers::pi * ours[v]);
  return theirs;
}

TEST(whole_cage, green_coordinates_of_the_suite_are_clean_and_have_two_blocks) {
  const CageVerdict verdict = judge_whole_cage(green, "green");
  EXPECT_EQ(found_in(verdict), "");
  ASSERT_TRUE(verdict.convention);
  EXPECT_TRUE(verdict.convention->is_ours());
  EXPECT_EQ(verdict.convention->sentence, "yours is ours");
}

TEST(whole_cage, other_conventions_are_said_and_are_no_defects) {
  const CageVerdict verdict = judge_whole_cage(other_green, "green");
  EXPECT_EQ(found_in(verdict), "");
  ASSERT_TRUE(verdict.convention);
  EXPECT_FALSE(verdict.convention->is_ours());
  EXPECT_EQ(
      verdict.convention->sentence,
      "yours is ours with psi times 4 pi divided by the face's area, phi times -4 pi (normals that point inward), "
      "the order psi, phi");
}

TEST(whole_cage, defects_in_another_convention_are_named) {
  const auto twice = [](const CageRequest& q) {
    auto weights = asked(zoo_cage_absolute_threshold, q);
    for (double& w : weights) w *= 2;
    return weights;
  };
  const CageVerdict verdict = judge_whole_cage(twice, "mean_value");
  EXPECT_EQ(found_in(verdict), "absolute_threshold");
  ASSERT_TRUE(verdict.convention);
  EXPECT_EQ(verdict.convention->sentence, "yours is ours with lambda times 2");
}

TEST(whole_cage, single_precision_in_another_convention_is_few_digits) {
  const auto rounded = [](const CageRequest& q) {
    auto values = other_green(q);
    for (double& x : values) x = static_cast<float>(x);
    return values;
  };
  const CageVerdict verdict = judge_whole_cage(rounded, "green");
  EXPECT_EQ(found_in(verdict), "few_digits");
  ASSERT_TRUE(verdict.convention);
  EXPECT_NE(verdict.convention->sentence.find("psi times 4 pi divided"), std::string::npos);
  EXPECT_NE(verdict.convention->sentence.find("; to six digits"), std::string::npos) << verdict.convention->sentence;
}

TEST(whole_cage, all_signs_turned_are_those_of_the_fundamental_solution) {
  const auto turned = [](const CageRequest& q) {
    auto values = green(q);
    for (double& x : values) x = -x;
    return values;
  };
  const CageVerdict verdict = judge_whole_cage(turned, "green");
  ASSERT_TRUE(verdict.convention);
  EXPECT_EQ(verdict.convention->sentence,
            "yours is ours with phi times -1, psi times -1 (the other sign of the fundamental solution)");
}

TEST(whole_cage, wrong_faces_are_not_blamed_on_the_sum_over_vertices) {
  const auto by_count = [](const CageRequest& q) {
    auto values = green(q);
    for (std::size_t f = q.vertices.size(); f < values.size(); ++f) values[f] *= static_cast<double>(q.faces.size());
    return values;
  };
  const CageVerdict verdict = judge_whole_cage(by_count, "green");
  EXPECT_EQ(found_in(verdict), "wrong_values");
  EXPECT_NE(verdict.findings.at(0).evidence.find("of all vertices, are right, the others off by"), std::string::npos)
      << verdict.findings.at(0).evidence;
}

TEST(whole_cage, not_a_number_has_no_cause_among_wrong_values) {
  const auto nothing = [](const CageRequest& q) {
    return std::vector<double>(q.vertices.size() + q.faces.size(), std::nan(""));
  };
  EXPECT_EQ(found_in(judge_whole_cage(nothing, "green")), "");
}

TEST(whole_cage, factors_that_depend_on_the_point_are_no_convention) {
  const auto drifting = [](const CageRequest& q) {
    auto values = green(q);
    for (double& x : values) x *= 1 + 1e-3 * q.points[0].x();
    return values;
  };
  const CageVerdict verdict = judge_whole_cage(drifting, "green");
  EXPECT_FALSE(verdict.convention);
  EXPECT_NE(found_in(verdict), "");
}

}  // namespace
}  // namespace cageproof::judge
