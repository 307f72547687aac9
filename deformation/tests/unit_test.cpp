// SPDX-License-Identifier: MIT
// Units of length, and what is said where digits are lost.
#include "support.h"

#include "cageproof/core/input_error.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace cageproof::deformation::test::unit_test {
namespace {

std::vector<Vec> times(double s, std::vector<Vec> points) {
  for (Vec& p : points) p *= s;
  return points;
}

// How far images in a unit s times smaller are from those in the cage's own, in sizes.
double change(const Case& c, const char* method, const std::vector<double>& parameters, double s) {
  const Images<double> here = deformed(*prepared(c.cage, method, parameters), c.posed, c.points);
  const Cage cage = c.cage.with(times(s, c.cage.vertices()), c.cage.faces());
  const Images<double> there = deformed(*prepared(cage, method, parameters), times(s, c.posed), times(s, c.points));
  double worst = 0;
  for (std::size_t i = 0; i < here.tensors[0].size(); ++i)
    keep_larger(worst, std::abs(there.tensors[0][i] / s - here.tensors[0][i]));
  return worst / c.size;
}

// Squares of what is solved leave the range of double long before lengths do.
TEST(unit, of_length_does_not_change_unit_free_methods) {
  const Case c = cube();
  for (const double s : {1e-90, 1e-76, 1e-12, 1e12, 1e80}) {
    EXPECT_LT(change(c, "biharmonic_weber", {1, 3}, s), 1e-12) << s;
    EXPECT_LT(change(c, "biharmonic_1_3", {1, 3, 1, 2}, s), 1e-12) << s;
    EXPECT_LT(change(c, "somigliana", {0, 0.3, 1, 0, 0.5}, s), 1e-12) << s;
    EXPECT_LT(change(c, "somigliana", {1, 0.3, 1, 0, 0.5}, s), 1e-12) << s;
  }
  EXPECT_GT(change(c, "biharmonic_1_3", {1, 3, 1, 0}, 10), 5e-3);
  EXPECT_THROW(change(c, "biharmonic_weber", {1, 3}, 1e-120), InputError);
}

// If densities are small compared with the harmonic layers, as gamma_d makes them in other units, Laplacians are nearly
// zero for all normal derivatives: images lose digits, and a warning says so.
TEST(unit, aligned_methods_keep_rotations_where_densities_are_small) {
  const Case c = cube();
  const double turn = 1.1, cosine = std::cos(turn), sine = std::sin(turn);
  const auto turned = [&](const Vec& v) { return Vec(cosine * v[0] - sine * v[1], sine * v[0] + cosine * v[1], v[2]); };
  // Images where densities are 1, 1e-8 and 1e-12 of what they are in the unit cube: found 1e-16, 7e-7 and 5e-3 of the
  // size, all but the first with a warning.
  for (const auto& [s, off] : {std::pair{1.0, 1e-13}, {1e-2, 1e-5}, {1e-3, 5e-2}}) {
    const Cage cage = c.cage.with(times(s, c.cage.vertices()), c.cage.faces());
    std::vector<Vec> posed, points = times(s, c.points);
    for (const Vec& v : cage.vertices()) posed.push_back(turned(v));
    for (const double alignment : {0., 2.}) {
      const auto deformer = prepared(cage, "ahap", {1, 1, alignment, 1, 1});
      const auto pose = deformer->pose({posed});
      const Images<double> found = deformer->images(*pose, points, 0);
      const double condition = pose->report().systems.at(0).condition;
      for (std::size_t p = 0; p < points.size(); ++p)
        EXPECT_LT((image(found, p) - turned(points[p])).norm() / cage.size(), off) << s << ' ' << alignment;
      EXPECT_EQ(warns_of(pose->report(), "digits") || warns_of(pose->report(), "deficient"), s < 1)
          << s << ' ' << alignment << ' ' << condition;
      if (s == 1) {
        EXPECT_LT(condition, 1e5) << alignment;
      }
    }
  }
  try {
    prepared(c.cage, "ahap", {1, 1, 0, 1, 0});
    ADD_FAILURE() << "Green coordinates have no Laplacians";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("gamma_d"), std::string::npos) << error.what();
  }
}

TEST(reported, cages_inside_out_wherever_normals_are_used) {
  for (const Case& c : {cube(), square()}) {
    std::vector<Vec> mirrored = c.cage.vertices();
    for (Vec& v : mirrored) v[0] = -v[0];
    for (const char* method : {"green", "somigliana", "biharmonic_1_3", "tp", "cauchy", "biharmonic_boundary"}) {
      if (!why_refused(deform_method_named(method), c.cage).empty()) continue;
      const auto deformer = prepared(c.cage, method);
      EXPECT_TRUE(warns_of(deformer->pose({mirrored})->report(), "inside out")) << c.name << ' ' << method;
      EXPECT_FALSE(warns_of(deformer->pose({c.posed})->report(), "inside out")) << c.name << ' ' << method;
    }
  }
}

// Normals that the user gives are not those of the posed cage.
TEST(reported, cages_inside_out_not_where_normals_are_given) {
  const Case c = cube();
  std::vector<Vec> mirrored = c.cage.vertices();
  for (Vec& v : mirrored) v[0] = -v[0];
  for (const char* method : {"green", "biharmonic_1_3", "biharmonic_direct"}) {
    const auto deformer = prepared(c.cage, method);
    const auto& normals = deformer->coordinates().elements().normals();
    EXPECT_FALSE(warns_of(deformer->pose({mirrored, {normals.begin(), normals.end()}})->report(), "inside out"))
        << method;
  }
}

TEST(reported, weights_and_ratios_that_cost_digits) {
  const Case c = cube();
  EXPECT_TRUE(warns_of(prepared(c.cage, "biharmonic_1_3", {1, 3, 1e-20, 0})->prepared(), "digits are lost"));
  // The size is the root of three, 1e-8 over its fourth power 1.1e-9.
  EXPECT_TRUE(warns_of(prepared(c.cage, "biharmonic_1_3", {1, 3, 1.0e-9, 0})->prepared(), "digits are lost"));
  EXPECT_TRUE(prepared(c.cage, "biharmonic_1_3", {1, 3, 1.2e-9, 0})->prepared().warnings.empty());
  EXPECT_TRUE(prepared(c.cage, "biharmonic_1_3")->prepared().warnings.empty());
  EXPECT_TRUE(warns_of(prepared(c.cage, "somigliana", {0, 0.5 - 1e-9, 0, 0, 0.5})->prepared(), "pole"));
  EXPECT_TRUE(prepared(c.cage, "somigliana")->prepared().warnings.empty());
}

// Densities are tiny compared with the harmonic layers, and rounding leaves AHAP little to go by.
TEST(reported, systems_of_poses_that_are_deficient) {
  const Case c = cube();
  const Cage tiny = c.cage.with(times(1e-6, c.cage.vertices()), c.cage.faces());
  const auto posed = prepared(tiny, "ahap", {1, 1, 2, 1, 1})->pose({times(1e-6, c.posed)});
  ASSERT_EQ(posed->report().systems.size(), 1u);
  EXPECT_TRUE(posed->report().systems[0].is_singular());
  EXPECT_TRUE(warns_of(posed->report(), "deficient rank"));
}

// A polygon of so many edges that one layer at its samples would take tens of gigabytes.
// Cages whose layers leave the range of double: those that multiply nothing do not matter, and others are named.
TEST(unit, that_layers_cannot_be_in_is_said_where_they_are_needed) {
  const Case c = cube();
  for (const double s : {1e150, 1e250}) {
    const Cage cage = c.cage.with(times(s, c.cage.vertices()), c.cage.faces());
    for (const char* method : {"biharmonic_1_3", "biharmonic_1_2", "biharmonic_weber", "tp"}) try {
        prepared(cage, method);
        ADD_FAILURE() << method << ' ' << s;
      } catch (const InputError& error) {
        EXPECT_NE(std::string(error.what()).find("leave the range of double"), std::string::npos) << error.what();
      }
    const Images<double> images = deformed(*prepared(cage, "biharmonic_direct"), cage.vertices(), times(s, c.points));
    for (std::size_t p = 0; p < c.points.size(); ++p)
      EXPECT_LT((image(images, p) / s - c.points[p]).norm(), 1e-14) << s;
  }
}

TEST(rejected, samples_that_no_memory_holds) {
  constexpr int count = 4000;
  std::vector<Vec> vertices;
  std::vector<Face> segments;
  for (int k = 0; k < count; ++k) {
    vertices.emplace_back(std::cos(2 * M_PI * k / count), std::sin(2 * M_PI * k / count), 0);
    segments.push_back({{k, (k + 1) % count, -1, -1}});
  }
  const Cage circle = Cage::make_polygon("circle", vertices, segments, {});
  try {
    prepared(circle, "biharmonic_weber", {5, 3});
    ADD_FAILURE() << "not refused";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("128000 samples times 8000 vertices and normal derivatives"),
              std::string::npos)
        << error.what();
  }
}

}  // namespace
}  // namespace cageproof::deformation::test::unit_test
