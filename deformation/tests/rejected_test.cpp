// SPDX-License-Identifier: MIT
// Poses that are refused, by every method that cannot take them: other numbers of vertices, numbers that are not
// finite, elements without area or length.
#include "settings.h"

#include <set>

namespace cageproof::deformation::test {
namespace {

std::string refusal(const Deformer<double>& deformer, const std::vector<Vec>& posed) {
  return refusal_of([&] { deformer.pose({posed, {}}); });
}

TEST(rejected, settings_of_tests_are_those_of_all_methods) {
  std::set<std::string_view> named;
  for (const Setting& s : settings()) named.insert(s.method);
  for (const DeformMethod& method : deform_methods()) EXPECT_TRUE(named.contains(method.name)) << method.name;
}

TEST(rejected, poses_of_other_numbers_of_vertices) {
  for (const Case& c : {cube(), l_shape()})
    for (const Setting& s : settings_on(c.cage)) {
      std::vector<Vec> few = c.posed, many = c.posed;
      few.pop_back();
      many.emplace_back(1, 2, 0);
      const auto& deformer = kept_with(c.cage, s);
      const auto expected = [&](const std::vector<Vec>& posed) {
        return "the posed cage has " + std::to_string(posed.size()) + " vertices, the rest cage " +
               std::to_string(c.posed.size());
      };
      EXPECT_EQ(refusal(deformer, few), expected(few)) << s.text();
      EXPECT_EQ(refusal(deformer, many), expected(many)) << s.text();
      EXPECT_EQ(refusal(deformer, {}), expected({})) << s.text();
    }
}

TEST(rejected, poses_that_are_not_finite) {
  for (const Case& c : {cube(), l_shape()})
    for (const Setting& s : settings_on(c.cage)) {
      const auto& deformer = kept_with(c.cage, s);
      for (const double bad : {static_cast<double>(NAN), static_cast<double>(INFINITY), -static_cast<double>(INFINITY)})
        for (int k = 0; k < c.cage.dimension(); ++k) {
          std::vector<Vec> lost = c.posed;
          lost[4][k] = bad;
          EXPECT_EQ(refusal(deformer, lost), "the posed cage's vertex 4 is not finite") << s.text();
        }
    }
}

// Images of a pose that is taken are numbers.
void expect_finite(const Case& c, const Deformer<double>& deformer, const Setting& s, const std::vector<Vec>& posed) {
  EXPECT_TRUE(is_finite(deformed(deformer, posed, c.points))) << c.name << ' ' << s.text();
}

TEST(rejected, elements_without_area_wherever_their_normals_are_used) {
  for (const Case& c : {cube(), l_shape()}) {
    const int d = c.cage.dimension();
    std::vector<Vec> posed = turned(c.posed, d);
    posed[1] = posed[0];
    for (const Setting& s : settings_on(c.cage)) {
      const auto& deformer = kept_with(c.cage, s);
      const std::string said = refusal(deformer, posed);
      if (!s.uses_normals || s.keeps_quads()) {
        EXPECT_EQ(said, "") << s.text();
        expect_finite(c, deformer, s, posed);
        continue;
      }
      EXPECT_TRUE(contains(said, d == 3 ? "has no area" : "has no length")) << s.text() << ": " << said;
      EXPECT_TRUE(contains(said, d == 3 ? "the posed triangle" : "the posed segment")) << s.text() << ": " << said;
    }
  }
}

// A pose whose sides have no area: Somigliana's global variant needs no normals without bulging, and a rotation of
// rank two is unique.
TEST(rejected, flattened_cages_wherever_normals_are_used) {
  const Case c = cube();
  const std::vector<Vec> flat = scaled(c.cage.vertices(), Vec(1, 1.5, 0));
  for (const Setting& s : settings_on(c.cage)) {
    const auto& deformer = kept_with(c.cage, s);
    EXPECT_EQ(contains(refusal(deformer, flat), "has no area"), s.uses_normals) << s.text();
    if (s.uses_normals) continue;
    expect_finite(c, deformer, s, flat);
    expect_finite(c, deformer, s, turned(flat, 3));
    EXPECT_FALSE(warns_of(deformer.pose({flat})->report(), "unique")) << s.text();
  }
}

// Three corners in line, in doubles that are exactly so.
TEST(rejected, elements_whose_corners_are_in_line) {
  const Case c = cube();
  const CageElements elements(c.cage, false, Triangulation::Shortest);
  const auto corners = elements.vertices_of(0);
  std::vector<Vec> posed = c.posed;
  posed[corners[2]] = posed[corners[0]] = Vec(1, 2, 3);
  posed[corners[1]] = Vec(2, 4, 6);
  posed[corners[2]] = Vec(1.5, 3, 4.5);
  for (const Setting& s : settings_on(c.cage))
    EXPECT_EQ(contains(refusal(kept_with(c.cage, s), posed), "the posed triangle 0 "),
              s.uses_normals && !s.keeps_quads())
        << s.text();
}

}  // namespace
}  // namespace cageproof::deformation::test
