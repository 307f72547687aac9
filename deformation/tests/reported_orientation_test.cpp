// SPDX-License-Identifier: MIT
// Poses that are inside out, counts of stretches, and images on the cage.
#include "settings.h"

namespace cageproof::deformation::test {
namespace {

bool has_normals_of_its_own(const Setting& s) {
  return deform_method_named(s.method).kind != s.method || s.method == "green" || s.method == "somigliana" ||
         s.method == "quad_green" || s.method == "quad_somigliana" || s.method == "cauchy" ||
         s.method == "biharmonic_boundary" || s.method == "biharmonic_goursat";
}

// Methods that know of no normals have no inside.
TEST(reported, poses_inside_out_by_every_method_with_normals) {
  const std::string words = "the posed cage is inside out";
  for (const Case& c : {cube(), l_shape()}) {
    const int d = c.cage.dimension();
    const std::vector<Vec> mirrored = turned(scaled(c.posed, Vec(-1, 1, 1)), d), proper = turned(c.posed, d);
    for (const Setting& s : settings_on(c.cage)) {
      const auto& deformer = kept_with(c.cage, s);
      EXPECT_EQ(warns_of(deformer.pose({mirrored})->report(), words), has_normals_of_its_own(s)) << c.name << s.text();
      EXPECT_FALSE(warns_of(deformer.pose({proper})->report(), words)) << c.name << ' ' << s.text();
    }
  }
}

// Reports on mirror images are true.
TEST(reported, poses_inside_out_say_whether_mirror_images_are_kept) {
  for (const Case& c : {cube(), l_shape()}) {
    const int d = c.cage.dimension();
    const Vec by = d == 2 ? Vec(1, -1, 1) : Vec(1, 1, -1);
    const std::vector<Vec> mirrored = turned(scaled(c.cage.vertices(), by), d),
                           expected = turned(scaled(c.points, by), d);
    for (const Setting& s : settings_on(c.cage)) {
      if (!has_normals_of_its_own(s)) continue;
      const auto& deformer = kept_with(c.cage, s);
      const auto posed = deformer.pose({mirrored});
      const bool kept = (image(deformer.images(*posed, c.points, 0), 0, d) - expected[0]).norm() < 1e-10;
      EXPECT_EQ(warns_of(posed->report(), "mirror images are not kept"), !kept) << c.name << s.text();
    }
  }
}

// Flat poses are not inside out, whatever rounding makes of their volumes.
TEST(reported, flat_poses_are_not_inside_out) {
  for (const Case& c : {cube(), l_shape()}) {
    const int d = c.cage.dimension();
    std::vector<Vec> flat = scaled(c.cage.vertices(), d == 2 ? Vec(1, 0, 1) : Vec(1, 1, 0));
    for (Vec& v : flat) v += Vec(.1, .2, 0);
    for (int turns = 0; turns < 8; ++turns) {
      EXPECT_FALSE(warns_of(report_of(c.cage, {"green", {{"stretch", 2}}}, flat), "inside out")) << c.name << turns;
      flat = turned(flat, d);
    }
  }
}

// However slender, a pose has an inside where its vertices' rounding does not decide it.
TEST(reported, slender_poses_are_inside_out_where_they_are) {
  for (const Case& c : {cube(), l_shape()}) {
    const int d = c.cage.dimension();
    for (const double width : {1e-3, 1e-7, 1e-12}) {
      const auto slender = [&](double sign) {
        return turned(scaled(c.cage.vertices(), d == 2 ? Vec(1, sign * width, 1) : Vec(1, width, sign * width)), d);
      };
      EXPECT_FALSE(warns_of(report_of(c.cage, {"green", {{"stretch", 2}}}, slender(1)), "inside out"))
          << c.name << width;
      EXPECT_TRUE(warns_of(report_of(c.cage, {"green", {{"stretch", 2}}}, slender(-1)), "inside out"))
          << c.name << width;
    }
  }
}

TEST(reported, negative_and_zero_stretches_are_counted) {
  // Mirrored, all twelve are -1, or none of them is better than nothing.
  const Case c = cube();
  const std::vector<Vec> mirrored = scaled(c.cage.vertices(), Vec(1, 1, -1));
  for (const char* method : {"ahap", "aaap", "tp"}) {
    const DeformationReport hard = report_of(c.cage, {method, {{"alignment", 0}}}, mirrored),
                            none = report_of(c.cage, {method, {{"alignment", 3}}}, mirrored);
    EXPECT_EQ(figure(hard, "negative sigma"), 12) << method;
    EXPECT_TRUE(warns_of(hard, "12 of 12 sigma are negative")) << method;
    EXPECT_NEAR(figure(hard, "least sigma"), -1, 1e-9) << method;
    EXPECT_GE(figure(none, "least sigma"), 0) << method;
    EXPECT_GT(figure(none, "zero sigma"), 0) << method;
    EXPECT_EQ(figure(report_of(c.cage, {method, {{"alignment", 3}}}, c.cage.vertices()), "zero sigma"), 0) << method;
  }
}

// Limits from inside: images there are those next to it, to the first order of the distance.
TEST(reported, points_on_the_cage_have_the_images_next_to_them) {
  for (const Case& c : {cube(), l_shape()}) {
    const int d = c.cage.dimension();
    const Vec on = d == 3 ? Vec(c.cage.vertices()[0] + .375 * (c.cage.vertices()[1] - c.cage.vertices()[0]) +
                                .25 * (c.cage.vertices()[2] - c.cage.vertices()[0]))
                          : Vec(.625 * c.cage.vertices()[0] + .375 * c.cage.vertices()[1]);
    const CageElements elements(c.cage, false, Triangulation::Shortest);
    ASSERT_FALSE(elements.touching(on).empty());
    const Vec inward = elements.normals()[elements.touching(on)[0].element];
    for (const Setting& s : settings_on(c.cage)) {
      const auto& deformer = kept_with(c.cage, s);
      const Images<double> images = deformed(deformer, c.posed, {on, on - 1e-9 * inward});
      EXPECT_LT((image(images, 0, d) - image(images, 1, d)).norm(), 1e-6) << c.name << ' ' << s.text();
    }
  }
}

}  // namespace
}  // namespace cageproof::deformation::test
