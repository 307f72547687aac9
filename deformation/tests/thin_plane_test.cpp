// SPDX-License-Identifier: MIT
// Polygons with a short edge, or with edges next to each other: where layers of what lies together differ from those
// elsewhere by more than double has digits for.
#include "settings.h"

#include <gtest/gtest.h>

namespace cageproof::deformation::test::thin_plane_test {
namespace {

using Corners = std::vector<std::array<double, 2>>;

// At rest.
Case thin(const std::string& name, const Corners& corners, const Corners& points) {
  Case found = polygon(name, corners, Corners(corners.size(), {0, 0}), Vec::Zero());
  found.points.clear();
  for (const auto& [x, y] : points) found.points.emplace_back(x, y, 0);
  return found;
}

// A pentagon with a corner cut off, and one with another vertex on an edge, next to the edge's end or in its middle.
Case cut(double t) {
  return thin("cut", {{-.1, .2}, {1.3, .1}, {1.2, 1.1 - t}, {1.2 - t, 1.1}, {.1, 1.4}}, {{.3, .5}, {.9, .9}});
}
Case split(double t, double at) {
  return thin("split", {{0, 0}, {at - t, 0}, {at, 0}, {1, .25}, {.75, 1}, {0, 1}}, {{.3, .4}, {.6, .7}});
}
Case notched(double t) {
  return thin("notched", {{0, 0}, {2, 0}, {2, 1}, {1 + t, 1}, {1 + t / 2, 1 - t}, {1, 1}, {0, 1.5}},
              {{.3, .4}, {1, .8}, {1.8, .1}});
}
Case slit(double t) {
  return thin("slit", {{0, 0}, {2, 0}, {2, 1}, {1 + t, 1}, {1 + t, .5}, {1, .5}, {1, 1}, {0, 1}},
              {{.3, .4}, {1.1, .2}, {1.8, .1}});
}
Case flat_bar(double t) {
  return thin("flat bar", {{0, 0}, {1, 0}, {1, t}, {0, t}}, {{.3, .4 * t}, {.5, .5 * t}, {.9, .125 * t}});
}
Case needle(double t) {
  return thin("needle", {{0, 0}, {1, 0}, {1, t}}, {{.625, .375 * t}, {.5, .25 * t}, {.9, .125 * t}});
}

// Methods that are not on the list lose nothing to begin with.
std::vector<Setting> layered_settings() {
  return {{"aaap"},
          {"tp"},
          {"ahap"},
          {"biharmonic_1_2"},
          {"biharmonic_1_2", {{"neumann", 1}}},
          {"biharmonic_1_3"},
          {"biharmonic_weber"},
          {"green"},
          {"cauchy"},
          {"somigliana"},
          {"aaap", {{"alignment", 1}}},
          {"tp", {{"alignment", 3}}}};
}

void expect_images(const Case& c, const Setting& setting, const std::vector<Vec>& posed,
                   const std::vector<Vec>& expected, double tolerance, double t) {
  const auto deformer = prepared_with(c.cage, setting);
  const Images<double> images = deformed(*deformer, posed, c.points);
  for (std::size_t p = 0; p < c.points.size(); ++p)
    EXPECT_LE((image(images, p, 2) - expected[p]).norm(), tolerance)
        << setting.text() << ' ' << c.name << ' ' << t << ' ' << p;
}

// In double aaap leaves 1e-12 of the size at t = 1e-3 and all of it at t = 1e-9; tp and biharmonic_1_2 less.
TEST(thin_plane, short_edges_cost_the_identity_nothing) {
  for (const double t : {1e-3, 1e-5, 1e-7, 1e-9})
    for (const Case& c : {cut(t), split(t, 1), split(t, .5), notched(t)})
      for (const Setting& setting : layered_settings()) expect_images(c, setting, c.posed, c.points, 1e-12 * c.size, t);
}

// In double biharmonic_1_2 and biharmonic_weber leave 1e-8 of the size at t = 1e-3.
TEST(thin_plane, edges_next_to_each_other_cost_the_identity_nothing) {
  for (const double t : {1e-3, 1e-5, 1e-7})
    for (const Case& c : {slit(t), flat_bar(t), needle(t)})
      for (const Setting& setting :
           {Setting{"biharmonic_1_2"}, {"biharmonic_1_3"}, {"biharmonic_weber"}, {"green"}, {"cauchy"}})
        expect_images(c, setting, c.posed, c.points, 1e-12 * c.size, t);
}

TEST(thin_plane, cages_are_solved_in_more_digits_where_layers_are_sampled) {
  const Case thin_one = cut(1e-3), stout = cut(.25);
  for (const char* method : {"aaap", "tp", "ahap", "biharmonic_1_2", "biharmonic_1_3", "biharmonic_weber"}) {
    EXPECT_EQ(figure(prepared(thin_one.cage, method)->prepared(), "digits of systems"), 50) << method;
    EXPECT_TRUE(std::isnan(figure(prepared(stout.cage, method)->prepared(), "digits of systems"))) << method;
  }
  EXPECT_TRUE(std::isnan(figure(prepared(thin_one.cage, "green")->prepared(), "digits of systems")));
}

// Numbers that are not rounded when they are turned by a quarter and made four times as large.
TEST(thin_plane, similarities_that_are_exact_are_kept) {
  const std::vector<Setting> settings{{"aaap"},  {"tp"},         {"ahap"},
                                      {"green"}, {"somigliana"}, {"biharmonic_1_2", {{"normals", 0}}}};
  for (const double t : {0x1p-10, 0x1p-20, 0x1p-30})
    for (const Case& c : {split(t, 1), split(t, .5), notched(t)}) {
      const auto moved = [](std::vector<Vec> points) {
        for (Vec& p : points) p = Vec(3 - 4 * p[1], 4 * p[0] - 5, 0);
        return points;
      };
      for (const Setting& setting : settings)
        expect_images(c, setting, moved(c.posed), moved(c.points), 4e-12 * c.size, t);
    }
}

// Derivatives on the cage are of the size of 1/t^2, and multiply the roundings of posed vertices.
TEST(thin_plane, rounded_poses_are_kept_or_warned_of) {
  int warned = 0;
  for (const double t : {1e-3, 1e-5, 1e-7})
    for (const Case& c : {cut(t), notched(t)})
      for (const Setting& setting : {Setting{"aaap"}, {"tp"}, {"biharmonic_1_3"}, {"green"}}) {
        const auto deformer = prepared_with(c.cage, setting);
        const auto posed = deformer->pose({turned(c.posed, 2), {}});
        const Images<double> images = deformed(*deformer, turned(c.posed, 2), c.points);
        const std::vector<Vec> expected = turned(c.points, 2);
        // The statement holds within a factor of ten.
        const double stated = posed->report().pose_rounding;
        EXPECT_EQ(stated > 0, setting.method != "green") << setting.text();
        for (std::size_t p = 0; p < c.points.size(); ++p)
          EXPECT_LE((image(images, p, 2) - expected[p]).norm(), (10 * stated + 1e-13) * c.size)
              << setting.text() << ' ' << c.name << ' ' << t;
        if (warns_of(posed->report(), "posed vertices are rounded to double")) {
          ++warned;
          continue;
        }
        for (std::size_t p = 0; p < c.points.size(); ++p)
          EXPECT_LE((image(images, p, 2) - expected[p]).norm(), 1e-11 * c.size)
              << setting.text() << ' ' << c.name << ' ' << t;
      }
  EXPECT_GE(warned, 8);
  EXPECT_LE(warned, 12);
  // The rest cage is what it is.
  for (const Case& c : {cut(1e-7), notched(1e-7)})
    EXPECT_FALSE(warns_of(prepared(c.cage, "aaap")->pose({c.posed, {}})->report(), "rounded to double"));
}

TEST(thin_plane, boundary_functions_keep_the_identity_or_warn) {
  for (const double t : {.25, 1e-3, 1e-5, 1e-7, 1e-9})
    for (const Case& c : {cut(t), split(t, 1), split(t, .5), notched(t), slit(t), flat_bar(t), needle(t)}) {
      const auto deformer = prepared(c.cage, "biharmonic_boundary");
      const bool warned = !deformer->prepared().warnings.empty();
      if (t > .1) EXPECT_FALSE(warned) << c.name;
      if (!warned) expect_images(c, {"biharmonic_boundary"}, c.posed, c.points, 1e-12 * c.size, t);
    }
}

// 50 digits of 144 edges would take a minute.
TEST(thin_plane, large_cages_stay_in_double_and_say_why_digits_are_lost) {
  const auto many = [](double t) {
    Corners corners;
    constexpr int edges = 140;
    for (int k = 0; k < edges; ++k) corners.push_back({double(k) / edges, 0});
    for (const std::array<double, 2>& corner : Corners{{1, 0}, {1, 1 - t}, {1 - t, 1}, {0, 1}})
      corners.push_back(corner);
    return thin("many", corners, {{.1, .2}});
  };
  EXPECT_TRUE(warns_of(prepared(many(1e-5).cage, "aaap")->prepared(), "face 141 is 7.1e+04 times shorter than the"));
  const std::string refusal = refusal_of([&] { prepared(many(1e-9).cage, "aaap"); });
  EXPECT_TRUE(contains(refusal, "double has no digits left of derivatives on element")) << refusal;
  EXPECT_TRUE(contains(refusal, "element 141 is 7.1e+08 times shorter than the longest edge")) << refusal;
}

}  // namespace
}  // namespace cageproof::deformation::test::thin_plane_test
