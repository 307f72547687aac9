// SPDX-License-Identifier: MIT
// Stretches of thin faces, and of posed faces at the ends of double's range.
#include "settings.h"

#include "cageproof/deformation/stretch.h"

#include <gtest/gtest.h>

namespace cageproof::deformation::test::thin_stretch_test {
namespace {

// A prism over a quadrangle one of whose corners is cut off at a distance t: thin faces beside large ones. The lid is
// cut so that triangles have their short side at any corner, and some have none that is short.
Case chamfered(double t) {
  const std::vector<std::array<double, 2>> outline{{-1, -1 + t}, {-1 + t, -1}, {1.1, -.9}, {1, 1}, {-.9, 1.2}};
  std::vector<Vec> vertices;
  for (const double z : {-.5, .6})
    for (const auto& [x, y] : outline) vertices.emplace_back(x, y, z);
  std::vector<Face> faces{{{1, 0, 4, -1}}, {{1, 4, 2, -1}}, {{2, 4, 3, -1}},
                          {{5, 6, 7, -1}}, {{5, 7, 9, -1}}, {{7, 8, 9, -1}}};
  for (int k = 0; k < 5; ++k) {
    const int next = (k + 1) % 5;
    faces.push_back({{k, next, next + 5, -1}});
    faces.push_back({{k, next + 5, k + 5, -1}});
  }
  Cage cage = Cage::make("chamfered", vertices, faces, {});
  const double size = cage.size();
  return {"chamfered", std::move(cage), vertices, {{.3, .2, .1}, {-.6, -.6, .2}, {-.99, -.98, .5}}, size};
}

// A tetrahedron on a base with a corner that is almost flat: its faces are slivers, which have no short side.
Case slivers(double t) {
  const std::vector<Vec> vertices{{0, 0, 0}, {1, .1, 0}, {.4, .04 + t, 0}, {.45, .045 + t / 3, t}};
  Cage cage = Cage::make("slivers", vertices, {{{0, 2, 1, -1}}, {{0, 1, 3, -1}}, {{1, 2, 3, -1}}, {{2, 0, 3, -1}}}, {});
  const double size = cage.size();
  return {"slivers", std::move(cage), vertices, {}, size};
}

TEST(thin_stretch, is_one_of_the_identity_however_thin_a_face_is) {
  for (const double t : {1e-3, 1e-6, 1e-8, 1e-11})
    for (const Case& c : {chamfered(t), slivers(t)}) {
      const CageElements elements(c.cage, false, Triangulation::Shortest);
      for (const Stretch stretch : {Stretch::Rms, Stretch::Mean, Stretch::Area, Stretch::Product})
        for (std::size_t e = 0; e < elements.count(); ++e)
          EXPECT_NEAR(stretch_of(stretch, elements, c.posed, e), 1, 4e-15) << c.name << ' ' << t << ' ' << e;
    }
}

TEST(thin_stretch, is_the_factor_of_similarities_where_numbers_are_not_rounded) {
  for (const double t : {0x1p-10, 0x1p-20, 0x1p-30})
    for (const Case& c : {chamfered(t), slivers(t)}) {
      const CageElements elements(c.cage, false, Triangulation::Shortest);
      std::vector<Vec> posed;
      posed.reserve(c.posed.size());
      for (const Vec& v : c.posed) posed.emplace_back(-4 * v[1], 4 * v[0], 4 * v[2]);
      for (const Stretch stretch : {Stretch::Rms, Stretch::Mean, Stretch::Area})
        for (std::size_t e = 0; e < elements.count(); ++e)
          EXPECT_NEAR(stretch_of(stretch, elements, posed, e), 4, 2e-14) << c.name << ' ' << t << ' ' << e;
    }
}

// Singular values 2 and 1/2 along the axes, of a triangle whose sides are none of them.
TEST(thin_stretch, is_what_singular_values_say) {
  for (const double t : {.5, 1e-4, 1e-9}) {
    const std::vector<Vec> vertices{{0, 0, 0}, {1, 0, 0}, {.5, t, 0}, {.5, t / 2, 1}};
    const Cage cage =
        Cage::make("tetrahedron", vertices, {{{0, 2, 1, -1}}, {{0, 1, 3, -1}}, {{1, 2, 3, -1}}, {{2, 0, 3, -1}}}, {});
    const std::vector<Vec> posed = scaled(vertices, Vec(2, .5, 1));
    const CageElements elements(cage, false, Triangulation::Shortest);
    EXPECT_NEAR(stretch_of(Stretch::Rms, elements, posed, 0), std::sqrt((4 + .25) / 2), 1e-14) << t;
    EXPECT_NEAR(stretch_of(Stretch::Mean, elements, posed, 0), 1.25, 1e-14) << t;
    EXPECT_NEAR(stretch_of(Stretch::Area, elements, posed, 0), 1, 1e-14) << t;
  }
}

// By squares over the squared area rms leaves 1e-10 of the size at t = 1e-8.
TEST(thin_stretch, costs_greens_identity_and_similarities_nothing) {
  for (const double t : {1e-3, 1e-6, 1e-8, 1e-10}) {
    const Case c = chamfered(t);
    for (const char* method : {"green", "quad_green"})
      for (const double stretch : {0., 1., 2.}) {
        const auto deformer = prepared_with(c.cage, {method, {{"stretch", stretch}}});
        for (const bool turn : {false, true}) {
          const auto moved = [&](const std::vector<Vec>& points) { return turn ? turned(points, 3) : points; };
          const Images<double> images = deformed(*deformer, moved(c.posed), c.points);
          const std::vector<Vec> expected = moved(c.points);
          for (std::size_t p = 0; p < c.points.size(); ++p)
            EXPECT_LE((image(images, p) - expected[p]).norm(), 1e-14 * c.size) << method << ' ' << stretch << ' ' << t;
        }
      }
  }
}

// Quads whose sides are almost in line, next to an edge of the cage that is no short one.
TEST(thin_stretch, costs_kept_quads_nothing) {
  for (const double t : {1e-3, 1e-6, 1e-8}) {
    const std::vector<Vec> vertices{{0, 0, 0}, {1, t, 0}, {2, 3 * t, 0}, {1, 2 * t, 0},
                                    {0, 0, 1}, {1, t, 1}, {2, 3 * t, 1}, {1, 2 * t, 1}};
    const Cage cage = Cage::make(
        "rhomb", vertices,
        {{{3, 2, 1, 0}}, {{4, 5, 6, 7}}, {{0, 1, 5, 4}}, {{1, 2, 6, 5}}, {{2, 3, 7, 6}}, {{3, 0, 4, 7}}}, {});
    const std::vector<Vec> points{{1, 1.5 * t, .5}, {.75, 1.1 * t, .25}};
    for (const double stretch : {0., 1., 2.}) {
      const auto deformer = prepared_with(cage, {"quad_green", {{"stretch", stretch}}});
      const Images<double> images = deformed(*deformer, vertices, points);
      for (std::size_t p = 0; p < points.size(); ++p)
        EXPECT_LE((image(images, p) - points[p]).norm(), 1e-13) << stretch << ' ' << t;
    }
  }
}

TEST(thin_stretch, of_huge_and_tiny_poses_stays_in_range) {
  const Case c = cube();
  for (const double factor : {1e160, 1e250, 1e-160, 1e-250})
    for (const Setting& setting : {Setting{"green"},
                                   {"green", {{"stretch", 1}}},
                                   {"green", {{"stretch", 2}}},
                                   {"quad_green"},
                                   {"somigliana", {{"variant", 1}}}}) {
      const std::vector<Vec> posed = scaled(c.cage.vertices(), Vec::Constant(factor));
      const Images<double> images = deformed(*prepared_with(c.cage, setting), posed, c.points);
      for (std::size_t p = 0; p < c.points.size(); ++p)
        EXPECT_LE((image(images, p) / factor - c.points[p]).norm(), 1e-13) << setting.text() << ' ' << factor;
    }
}

TEST(thin_stretch, says_of_edges_beyond_double_that_they_are) {
  const Case c = cube(), flat = square();
  for (const char* method : {"green", "quad_green", "biharmonic_1_3"}) {
    const auto deformer = prepared(c.cage, method);
    std::vector<Vec> posed = c.cage.vertices();
    for (Vec& v : posed) v = v.unaryExpr([](double x) { return x > 0 ? 1e308 : -1e308; });
    const std::string refusal = refusal_of([&] { deformer->pose({posed, {}}); });
    EXPECT_TRUE(contains(refusal, "longer than the largest number of double")) << method << ": " << refusal;
    EXPECT_TRUE(contains(refusal, " 0 (vertices")) << method << ": " << refusal;
  }
  const std::vector<Vec> posed = scaled(flat.cage.vertices(), Vec(1.7e308, 1.7e308, 1));
  const std::string refusal = refusal_of([&] { prepared(flat.cage, "green")->pose({posed, {}}); });
  EXPECT_TRUE(refusal.empty() || contains(refusal, "longer than the largest number of double")) << refusal;
}

}  // namespace
}  // namespace cageproof::deformation::test::thin_stretch_test
