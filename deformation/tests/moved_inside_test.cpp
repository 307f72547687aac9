// SPDX-License-Identifier: MIT
// Points on slanted faces, which rounding of their coordinates puts next to these.
#include "quad_cases.h"

#include "cageproof/deformation/moved_inside.h"
#include "cageproof/deformation/point_images.h"

#include <gtest/gtest.h>

namespace cageproof::deformation::test {
namespace {

std::vector<Vec> centres_of(const CageElements& elements) {
  std::vector<Vec> centres;
  for (std::size_t e = 0; e < elements.count(); ++e) {
    Vec sum = Vec::Zero();
    for (const Vec& corner : elements.corners(e)) sum += corner;
    centres.emplace_back(sum / static_cast<double>(elements.corners(e).size()));
  }
  return centres;
}

TEST(MovedInside, takes_centres_of_faces_onto_the_cage) {
  int outside_before = 0;
  for (const std::string name : {"icosphere", "twisted-bar", "l-shape"}) {
    const Cage cage = embedded_cage(name);
    const CageElements elements(cage, false, Triangulation::Shortest);
    const Inside inside(elements);
    const std::vector<Vec> centres = centres_of(elements);
    int outside = 0;
    for (const Vec& p : centres) outside += inside.holds(p) ? 0 : 1;
    outside_before += outside;
    const MovedInside found = moved_inside(elements, centres, 1e-12 * cage.size(), 2);
    EXPECT_EQ(found.count, outside) << name;
    EXPECT_LT(found.farthest, 1e-14 * cage.size()) << name;
    for (std::size_t p = 0; p < centres.size(); ++p) {
      EXPECT_TRUE(inside.holds(found.points[p])) << name << ' ' << p;
      if (inside.holds(centres[p])) EXPECT_EQ(found.points[p], centres[p]);
    }
  }
  EXPECT_GT(outside_before, 10);
}

TEST(MovedInside, leaves_points_that_are_further_out) {
  const Cage cage = embedded_cage("cube");
  const CageElements elements(cage, false, Triangulation::Shortest);
  const std::vector<Vec> points{{.5 + 1e-6, .1, .2}, {.1, .2, .3}, {.5, .1, .2}, {-.5 - 1e-3, -.5 - 1e-3, 0}};
  const MovedInside none = moved_inside(elements, points, 1e-7, 1);
  EXPECT_EQ(none.points, points);
  EXPECT_EQ(none.count, 0U);
  const MovedInside one = moved_inside(elements, points, 2e-6, 1);
  EXPECT_EQ(one.count, 1U);
  EXPECT_EQ(one.points[0][0], .5);
  EXPECT_NEAR((one.points[0] - Vec(.5, .1, .2)).norm(), 0, 1e-15);
  EXPECT_EQ(one.points[3], points[3]);
  EXPECT_EQ(moved_inside(elements, points, 2e-3, 1).points[3], Vec(-.5, -.5, 0));
}

// Next to edges and vertices, acute ones too, of cages turned anyhow and of any size.
TEST(MovedInside, takes_points_beside_edges_and_vertices) {
  for (const std::string name : {"corner", "cube", "icosphere", "spiky-box", "l-block"})
    for (const double unit : {1., 1e-100, 1e100})
      for (int turn = 0; turn < 3; ++turn) {
        const Cage rest = name == "corner"
                              ? Cage::make("corner", {{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {0, 0, 2}},
                                           {{{0, 2, 1, -1}}, {{0, 1, 3, -1}}, {{1, 2, 3, -1}}, {{0, 3, 2, -1}}})
                              : embedded_cage(name);
        const Eigen::Matrix3d turned = Eigen::AngleAxisd(turn, Vec(1, 2, 3).normalized()).toRotationMatrix();
        std::vector<Vec> vertices;
        for (const Vec& v : rest.vertices()) vertices.emplace_back(unit * (turned * v));
        const Cage cage = rest.with(vertices, rest.faces());
        const CageElements elements(cage, false, Triangulation::Shortest);
        const Inside inside(elements);
        std::vector<Vec> points;
        for (std::size_t e = 0; e < elements.count(); ++e) {
          const auto c = elements.corners(e);
          Vec out = elements.normals()[e];
          for (const double share : {0., 0.3, 0.5})
            points.emplace_back((1 - share) * c[0] + share * c[1] + 1e-5 * cage.size() * out);
        }
        const MovedInside found = moved_inside(elements, points, 1e-4 * cage.size(), 2);
        for (std::size_t p = 0; p < points.size(); ++p)
          EXPECT_TRUE(inside.holds(found.points[p])) << name << ' ' << unit << ' ' << turn << ' ' << p;
        EXPECT_LT(found.farthest, 2e-5 * cage.size());
      }
}

TEST(MovedInside, knows_bilinear_quads) {
  for (const Case& c : {twisted_cube(), mixed_cage()}) {
    const CageElements elements(c.cage, true, Triangulation::Shortest);
    const Inside inside(elements);
    std::vector<Vec> points;
    for (std::size_t e = 0; e < elements.count(); ++e) {
      const auto corners = elements.corners(e);
      Vec centre = Vec::Zero();
      for (const Vec& corner : corners) centre += corner / static_cast<double>(corners.size());
      points.emplace_back(centre + 1e-9 * elements.normals()[e]);
    }
    const MovedInside found = moved_inside(elements, points, 1e-8, 1);
    EXPECT_EQ(found.count, points.size()) << c.name;
    EXPECT_LT(found.farthest, 1.1e-9) << c.name;
    for (const Vec& p : found.points) EXPECT_TRUE(inside.holds(p)) << c.name;
  }
}

}  // namespace
}  // namespace cageproof::deformation::test
