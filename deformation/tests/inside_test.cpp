// SPDX-License-Identifier: MIT
// Points inside cages whose quads are kept: between a bilinear quad and the triangles that it could be split in.
#include "quad_cases.h"

#include "cageproof/core/coordinates/coordinates.h"
#include "cageproof/deformation/inside.h"

#include <gtest/gtest.h>

namespace cageproof::deformation::test {
namespace {

// Within the tetrahedra of all quads' corners, which the quads cut in two; Green's coordinates of vertices sum to one
// inside, and to zero outside.
TEST(inside, is_where_coordinates_sum_to_one) {
  for (const Case& c : {twisted_cube(), mixed_cage()}) {
    const CageCoordinates coordinates(c.cage, coordinate_kind_named("quad_green"), CoordinateOptions{});
    const Inside inside(coordinates.elements());
    std::vector<Vec> points;
    for (std::size_t e = 0; e < coordinates.elements().count(); ++e) {
      if (coordinates.elements().type(e).flat) continue;
      const auto q = coordinates.elements().corners(e);
      for (int i = 0; i < 20; ++i) {
        RandomStream random(1, c.name, static_cast<int>(e) * 20 + i);
        Vec point = Vec::Zero();
        double sum = 0;
        for (const Vec& corner : q) {
          const double share = random.uniform(0, 1);
          point += share * corner;
          sum += share;
        }
        points.emplace_back(point / sum);
      }
      // On the planes of three corners, and on the quad.
      points.emplace_back(q[0] / 2 + q[1] / 4 + q[2] / 4);
      points.emplace_back(q[1] / 2 + q[2] / 4 + q[3] / 4);
      points.emplace_back((q[0] + q[1] + q[2] + q[3]) / 4);
    }
    int within = 0;
    for (const Vec& point : points) {
      const auto blocks = coordinates.at<double>(point, 0);
      double sum = 0;
      for (const double phi : blocks[0].value) sum += phi;
      EXPECT_EQ(inside.holds(point), sum > 0.5) << c.name << ": " << point.transpose();
      within += inside.holds(point) ? 1 : 0;
    }
    EXPECT_GT(within, 20);
    EXPECT_LT(within + 20, static_cast<int>(points.size()));
  }
}

}  // namespace
}  // namespace cageproof::deformation::test
