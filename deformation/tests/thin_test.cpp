// SPDX-License-Identifier: MIT
// Cages with an element so thin that second derivatives at samples lose digits.
#include "settings.h"

#include "cageproof/core/cage/embedded_cages.h"

#include <gtest/gtest.h>

namespace cageproof::deformation::test::thin_test {
namespace {

// A tetrahedron without its tip, of which a share is cut off: the cut is small, and its neighbours are needles.
Case truncated(double cut) {
  const Vec tip(.2, .15, .9);
  std::vector<Vec> vertices{{.1, .2, .05}, {1.2, .1, -.1}, {.3, 1.1, .2}};
  for (int k = 0; k < 3; ++k) vertices.emplace_back(tip + cut * (vertices[k] - tip));
  const std::vector<Face> faces{{{0, 2, 1, -1}}, {{3, 4, 5, -1}}, {{0, 1, 4, -1}}, {{0, 4, 3, -1}},
                                {{1, 2, 5, -1}}, {{1, 5, 4, -1}}, {{2, 0, 3, -1}}, {{2, 3, 5, -1}}};
  Cage cage = Cage::make("truncated", vertices, faces, {});
  const double size = cage.size();
  return {"truncated", std::move(cage), vertices, {{.4, .4, .2}, {.5, .3, .25}, {.25, .3, .6}}, size};
}

// In double aaap and tp leave 2e-12, 1e-8 and 2e-3 of the last three.
TEST(thin, elements_cost_the_identity_nothing) {
  for (const double cut : {3e-2, 1e-2, 1e-3, 1e-5}) {
    const Case c = truncated(cut);
    for (const Setting& setting : {Setting{"aaap"},
                                   {"tp"},
                                   {"biharmonic_1_2"},
                                   {"biharmonic_1_3"},
                                   {"ahap"},
                                   {"aaap", {{"alignment", 2.}}},
                                   {"tp", {{"alignment", 3.}}}}) {
      const auto deformer = prepared_with(c.cage, setting);
      const Images<double> images = deformed(*deformer, c.posed, c.points);
      for (std::size_t p = 0; p < c.points.size(); ++p)
        EXPECT_LE((image(images, p) - c.points[p]).norm(), 1e-12 * c.size) << setting.text() << ' ' << cut;
    }
  }
}

// Systems are asked only for the difference between a pose and a similarity. Sums of layers leave 3e-13 of the cage's
// size here.
TEST(thin, cages_that_are_solved_in_double_keep_the_identity_to_rounding) {
  const Cage cage = embedded_cage("pinch-1e-5");
  const std::vector<Vec> points{{.125, .1, .475}, {.3, .3, -.45}, {.02, .01, .1}};
  for (const Setting& setting : {Setting{"biharmonic_1_3"},
                                 {"biharmonic_weber"},
                                 {"ahap"},
                                 {"ahap", {{"alignment", 1.}}},
                                 {"ahap", {{"alignment", 2.}}},
                                 {"ahap", {{"alignment", 3.}}}}) {
    const auto deformer = prepared_with(cage, setting);
    EXPECT_TRUE(std::isnan(figure(deformer->prepared(), "digits of systems"))) << setting.text();
    const Images<double> images = deformed(*deformer, cage.vertices(), points);
    for (std::size_t p = 0; p < points.size(); ++p)
      EXPECT_LE((image(images, p) - points[p]).norm(), 4e-15 * cage.size()) << setting.text();
  }
}

// Double has no digits left of values at samples where needles are much thinner still, and refused these.
TEST(thin, elements_are_solved_in_more_digits_where_values_have_none_in_double) {
  const Case c = truncated(1e-9);
  const auto deformer = prepared(c.cage, "biharmonic_1_3");
  EXPECT_EQ(figure(deformer->prepared(), "digits of systems"), 50);
  const Images<double> images = deformed(*deformer, c.posed, c.points);
  for (std::size_t p = 0; p < c.points.size(); ++p) EXPECT_LE((image(images, p) - c.points[p]).norm(), 1e-12 * c.size);
}

TEST(thin, elements_are_solved_in_more_digits_where_derivatives_on_the_cage_are_taken) {
  const Case needles = truncated(1e-3), stout = cube();
  for (const char* method : {"aaap", "tp", "biharmonic_1_2"}) {
    EXPECT_EQ(figure(prepared(needles.cage, method)->prepared(), "digits of systems"), 50) << method;
    EXPECT_TRUE(std::isnan(figure(prepared(stout.cage, method)->prepared(), "digits of systems"))) << method;
  }
  EXPECT_TRUE(std::isnan(figure(prepared(needles.cage, "ahap")->prepared(), "digits of systems")));
  const auto deformer = prepared(needles.cage, "tp");
  const auto free = with_other_parameters(deform_method_named("tp"), *deformer, {1, 1, 2});
  EXPECT_EQ(figure(free->prepared(), "digits of systems"), 50);
}

// With so many samples 50 digits would take minutes.
TEST(thin, elements_that_stay_in_double_are_named) {
  const Case c = truncated(1e-2);
  const auto deformer = prepared(c.cage, "biharmonic_1_2", {5, 3});
  EXPECT_TRUE(warns_of(deformer->prepared(), "times as long as high")) << deformer->prepared().warnings.size();
  EXPECT_TRUE(std::isnan(figure(deformer->prepared(), "digits of systems")));
}

}  // namespace
}  // namespace cageproof::deformation::test::thin_test
