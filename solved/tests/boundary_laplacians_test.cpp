// SPDX-License-Identifier: MIT
// Laplacians at boundary nodes as linear maps from the data, and systems that are solved in the cage's own unit.
#include "support.h"

#include "cageproof/core/input_error.h"

#include <gtest/gtest.h>

namespace cageproof::solved::test::boundary_laplacians_test {
namespace {

constexpr double kVertices = 0, kMidpoints = 1, kDiameter = 0, kOwn = 1;

// The nodes of polygons with two pieces per edge are the vertices, then the midpoints.
std::vector<Vec> nodes_of(const Corners& corners) {
  std::vector<Vec> nodes;
  for (const auto& [x, y] : corners) nodes.emplace_back(x, y, 0);
  for (std::size_t k = 0; k < corners.size(); ++k) nodes.emplace_back((nodes[k] + nodes[(k + 1) % corners.size()]) / 2);
  return nodes;
}

// The square system, where it is regular, makes the Laplacian inside come to those at the nodes: in 100 digits, 1e-25
// from them.
TEST(boundary_laplacians, are_limits_of_the_coordinates_own) {
  for (const Corners* corners : {&triangle, &convex_pentagon})
    for (const double unit : {kDiameter, kOwn}) {
      const CageCoordinates c = coordinates(polygon(*corners), "biharmonic_boundary", {2, kVertices, unit});
      const auto found = c.boundary_laplacians<double>();
      const auto exact = c.boundary_laplacians<Mp50>();
      double condition = 1;
      for (const SolvedSystem& s : c.solved()) condition = std::max(condition, s.condition);
      ASSERT_EQ(found.size(), 2U);
      const std::vector<Vec> nodes = nodes_of(*corners);
      const Vec middle(0.5, 0.4, 0);
      for (std::size_t b = 0; b < 2; ++b) {
        ASSERT_EQ(found[b].tensors[0].size(), nodes.size() * corners->size());
        double largest = 0;
        for (const double x : found[b].tensors[0]) largest = std::max(largest, std::abs(x));
        for (std::size_t n = 0; n < nodes.size(); ++n) {
          const Vec3<Mp100> near = convert<Mp100>(nodes[n]) + Mp100("1e-25") * convert<Mp100>(Vec(middle - nodes[n]));
          const std::vector<Mp100> hessian = c.at<Mp100>(near, 2)[b].of(2);
          for (std::size_t k = 0; k < corners->size(); ++k) {
            const auto truth = static_cast<Mp50>(Mp100(hessian[4 * k] + hessian[4 * k + 3]));
            const std::size_t at = n * found[b].stride[0] + k;
            // The distance times its own logarithm.
            EXPECT_LT(abs(Mp50(exact[b].tensors[0][at] - truth)), Mp50("1e-23") * largest)
                << "block " << b << ", node " << n << ", coordinate " << k << ", unit " << unit;
            EXPECT_NEAR(found[b].tensors[0][at], static_cast<double>(truth), 1e-15 * condition * largest);
          }
        }
      }
    }
}

TEST(boundary_laplacians, of_affine_data_vanish_and_have_the_users_unit) {
  for (const double own : {kDiameter, kOwn}) {
    const CageCoordinates c = coordinates(polygon(l_shape), "biharmonic_boundary", {4, kMidpoints, own});
    const auto found = c.boundary_laplacians<double>();
    const auto& vertices = c.elements().vertices();
    const auto& normals = c.elements().normals();
    const std::size_t nodes = found[0].tensors[0].size() / 6;
    EXPECT_EQ(nodes, 24U);
    for (std::size_t n = 0; n < nodes; ++n) {
      double one = 0;
      Vec x = Vec::Zero();
      for (std::size_t k = 0; k < 6; ++k) {
        one += found[0].tensors[0][6 * n + k];
        x += found[0].tensors[0][6 * n + k] * vertices[k] + found[1].tensors[0][6 * n + k] * normals[k];
      }
      EXPECT_LT(std::abs(one) + x.norm(), 1e-11) << n;
    }
  }
  const auto small = coordinates(polygon(l_shape), "biharmonic_boundary").boundary_laplacians<double>(),
             large = coordinates(polygon(l_shape, 5), "biharmonic_boundary").boundary_laplacians<double>();
  for (std::size_t b = 0; b < 2; ++b)
    for (std::size_t i = 0; i < small[b].tensors[0].size(); ++i)
      EXPECT_NEAR(large[b].tensors[0][i], small[b].tensors[0][i] / (b == 0 ? 25 : 5), 1e-11);
}

TEST(boundary_laplacians, of_order_three_are_data_and_of_other_kinds_are_none) {
  const auto found =
      coordinates(polygon(triangle), "triharmonic_boundary", {2, kMidpoints}).boundary_laplacians<double>();
  ASSERT_EQ(found.size(), 3U);
  const std::vector<double> hats{1, 0, 0, 0, 1, 0, 0, 0, 1, .5, .5, 0, 0, .5, .5, .5, 0, .5};
  EXPECT_EQ(found[2].tensors[0], hats);
  for (const double x : found[0].tensors[0]) EXPECT_EQ(x, 0);
  for (const char* kind : {"harmonic", "cauchy", "green"})
    EXPECT_THROW(coordinates(polygon(triangle), kind).boundary_laplacians<double>(), InputError) << kind;
}

// The logarithm of the unit is in the paper's numbers.
TEST(unit, of_the_cage_is_that_of_the_paper) {
  const Vec point(0.5, 0.75, 0);
  const auto at = [&](double size, double unit) {
    const CageCoordinates c = coordinates(polygon(l_shape, size), "biharmonic_boundary", {2, kMidpoints, unit});
    EXPECT_LT(affine_errors(c, size * point, 0)[0], 1e-12) << size;
    std::vector<double> values = values_at(c, size * point);
    for (std::size_t k = 6; k < 12; ++k) values[k] /= size;
    return values;
  };
  EXPECT_LT(largest_difference(at(1, kDiameter), at(100, kDiameter)), 1e-13);
  EXPECT_GT(largest_difference(at(1, kOwn), at(100, kOwn)), 1e-3);
  // Where the diameter is one, the two are the same.
  const double diameter = std::sqrt(8.);
  EXPECT_LT(largest_difference(at(1, kDiameter), at(1 / diameter, kOwn)), 1e-13);
  EXPECT_THROW(coordinates(polygon(l_shape), "biharmonic_boundary", {2, kMidpoints, 2}), InputError);
}

// The paper's offset is a part of the diameter in either unit: what it costs hardly depends on the cage's size, of
// which an offset by a length of its own would cost a hundredth.
TEST(unit, does_not_change_the_offset) {
  const auto cost = [](double size) {
    const Cage cage = polygon(l_shape, size);
    const Vec point = size * Vec(0.25, 0.5, 0);
    const std::vector<double> parameters{2, kMidpoints, kOwn};
    const CageCoordinates offset(cage, coordinate_kind_named("biharmonic_boundary"),
                                 CoordinateOptions{.evaluation = "offset-1e-6", .parameters = parameters});
    const auto moved = offset.at<double>(point, 0)[0].value,
               exact = coordinates(cage, "biharmonic_boundary", parameters).at<double>(point, 0)[0].value;
    return largest_difference(moved, exact);
  };
  EXPECT_GT(cost(100), cost(1) / 5);
  EXPECT_LT(cost(100), cost(1) * 5);
}

}  // namespace
}  // namespace cageproof::solved::test::boundary_laplacians_test
