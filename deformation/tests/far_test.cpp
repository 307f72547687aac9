// SPDX-License-Identifier: MIT
// Cages far from the origin, beside which they are small.
#include "settings.h"
#include "variational_cases.h"

#include "cageproof/deformation/constrained.h"
#include "../src/own_place.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace cageproof::deformation::test {
namespace {

std::vector<Vec> moved(std::vector<Vec> points, const Vec& by) {
  for (Vec& p : points) p += by;
  return points;
}

double largest_of(const std::vector<Vec>& points) {
  double largest = 0;
  for (const Vec& p : points) largest = std::max(largest, p.cwiseAbs().maxCoeff());
  return largest;
}

// Images under the identity, in roundings of the largest coordinate. Before poses had a place of their own, the error
// grew with the square of the offset: 5e5 roundings of tp at 1e6 sizes.
TEST(far, from_the_origin_all_methods_keep_the_identity_to_rounding) {
  for (const Case& c : {cube(), pentagon()})
    for (const DeformMethod& method : deform_methods()) {
      if (!why_refused(method, c.cage).empty()) continue;
      for (const double sizes : {1e3, 1e6, 1e8}) {
        const Vec by = sizes * c.size * Vec(1, -0.7, c.cage.dimension() == 3 ? 0.4 : 0);
        // Turned, so that no face lies in a plane of the axes, where roundings vanish.
        const int d = c.cage.dimension();
        const std::vector<Vec> vertices = moved(turned(c.cage.vertices(), d), by),
                               points = moved(turned(c.points, d), by);
        const Images<double> images =
            deformed(*prepared(c.cage.with(vertices, c.cage.faces()), method.name), vertices, points);
        for (std::size_t p = 0; p < points.size(); ++p)
          EXPECT_LE((image(images, p, d) - points[p]).norm(), 4 * 0x1p-53 * largest_of(vertices))
              << c.name << ' ' << method.name << ' ' << sizes;
      }
    }
}

// A shift of the pose adds the shift to each image, wherever the posed cage goes.
TEST(far, poses_are_shifted_as_they_are) {
  const Case c = cube();
  const Vec by = 0x1p40 * Vec(1, -3, 2);
  for (const char* method : {"mean_value", "green", "somigliana", "biharmonic_1_3", "biharmonic_1_2", "tp"}) {
    const auto deformer = prepared(c.cage, method);
    const Images<double> here = deformed(*deformer, c.posed, c.points, 1),
                         there = deformed(*deformer, moved(c.posed, by), c.points, 1);
    for (std::size_t p = 0; p < c.points.size(); ++p)
      EXPECT_LE((image(there, p) - by - image(here, p)).norm(), 0x1p-53 * 8 * by.norm()) << method;
    for (std::size_t k = 0; k < here.tensors[1].size(); ++k)
      EXPECT_NEAR(there.tensors[1][k], here.tensors[1][k], 2e-2) << method << ": vertices are rounded to 5e-4";
  }
}

TEST(far, constraints_are_met_to_rounding) {
  const Case c = square();
  const Vec by(1e7, -3e6, 0);
  const std::vector<Vec> vertices = moved(c.cage.vertices(), by), points = moved(c.points, by);
  const Cage cage = c.cage.with(vertices, c.cage.faces());
  Constraints constraints;
  for (const Vec& at : {Vec(.2, .3, 0), Vec(.7, .2, 0), Vec(.5, .8, 0)})
    constraints.positions.push_back({at + by, at + by + Vec(.25, .5, 0)});
  const ConstraintMethod* const method = find_constraint_method("thickness");
  ASSERT_NE(method, nullptr);
  const auto posed = prepare_constrained(*method, cage, constraints, {});
  const auto pose = posed->pose();
  EXPECT_EQ(pose->report().unsolved, "");
  const Images<double> images = posed->images(*pose, points, 0);
  EXPECT_LE((image(images, 0, 2) - points[0] - Vec(.25, .5, 0)).norm(), 8 * 0x1p-53 * 1e7);
  const std::vector<Vec> found = pose->vertices();
  ASSERT_EQ(found.size(), vertices.size());
  for (std::size_t v = 0; v < found.size(); ++v)
    EXPECT_LE((found[v] - vertices[v] - Vec(.25, .5, 0)).norm(), 8 * 0x1p-53 * 1e7);
}

// The bar's own coefficients, of which two Hessians leave many free, are the least wherever the bar is. Seen from the
// origin they were as large as the offset, and images had its roundings times a thousand.
TEST(far, freedom_that_constraints_leave_is_filled_next_to_the_cage) {
  const Case c = bar();
  const auto image_at = [&](const Vec& by) {
    Constraints constraints = bar_constraints(c.cage);
    constraints.hessians.resize(2);
    for (auto& [at, to] : constraints.positions) at += by, to += by;
    for (auto* places : {&constraints.rotations, &constraints.hessians})
      for (Vec& at : *places) at += by;
    const Variational<double> model(c.cage.with(moved(c.cage.vertices(), by), c.cage.faces()), constraints,
                                    bar_options(Subspace::Biharmonic, 5));
    const auto posed = model.pose();
    EXPECT_TRUE(warns_of(posed->report(), "unknowns free"));
    return Vec(image(model.images(*posed, std::vector<Vec>{c.points[0] + by}, 0), 0) - by);
  };
  const Vec expected = image_at(Vec::Zero());
  // Places are rounded by 1e-10 there.
  EXPECT_LT((image_at({0x1p20, -0x1p19, 0x1p18}) - expected).norm(), 1e-8);
}

// Points next to the origin stay where they are.
TEST(own_place, is_next_to_points_and_steps_from_it_are_exact) {
  EXPECT_EQ(own_place({}), Vec::Zero());
  EXPECT_EQ(own_place(cube().cage.vertices()), Vec::Zero());
  EXPECT_EQ(own_place({Vec(1, 1, 1), Vec(std::numeric_limits<double>::infinity(), 0, 0)}), Vec::Zero());
  EXPECT_EQ(own_place({Vec(3, 5, 7), Vec(3, 5, 7)}), Vec(3, 5, 7));
  for (const double offset : {1.1, 1.9, 2.3, 3.7, 1e3, 1e10, 1e15, -2.1, -77.7, 1e300}) {
    const std::vector<Vec> points = moved({{-.37, .11, -.5}, {.63, 1. / 3, 0}, {1e-3, -.2, .4}}, Vec(offset, 1, 0));
    const Vec place = own_place(points);
    for (const Vec& p : points) {
      const Vec step = p - place;
      EXPECT_LE(step.cwiseAbs().maxCoeff(), 4) << offset;
      for (int k = 0; k < 3; ++k) EXPECT_EQ(Mp50(step[k]), Mp50(Mp50(p[k]) - Mp50(place[k]))) << offset;
    }
  }
}

}  // namespace
}  // namespace cageproof::deformation::test
