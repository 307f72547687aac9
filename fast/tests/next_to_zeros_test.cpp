// SPDX-License-Identifier: MIT
// Where a formula is next to a zero, what cancels has roundings of its own: results against enclosures.
#include "cageproof/core/catalogue/evaluation.h"

#include <gtest/gtest.h>

#include <cmath>

namespace cageproof::fast {
namespace {

using Points = std::vector<Vec3<double>>;

// The largest difference from an enclosure's middle over its largest entry.
double relative_error(const char* formula, const char* evaluation, const Points& corners, const Vec3<double>& point,
                      int order, std::span<const double> parameters = {}) {
  Result<double> found;
  evaluation_named(formula, evaluation)(
      Query<double>{.corners = corners, .point = point, .order = order, .parameters = parameters}, found);
  const std::vector<Mp50> wide_parameters(parameters.begin(), parameters.end());
  Points::size_type i = 0;
  std::vector<Vec3<Mp50>> wide;
  for (const Vec3<double>& corner : corners) wide.push_back(convert<Mp50>(corner));
  Result<Mp50> truth;
  evaluation_named(formula, "certified")(
      Query<Mp50>{.corners = wide, .point = convert<Mp50>(point), .order = order, .parameters = wide_parameters},
      truth);
  EXPECT_TRUE(truth.converged);
  double error = 0, largest = 0;
  for (const Mp50& x : truth.of(order)) {
    error = std::max(error, std::abs(static_cast<double>(Mp50(x - Mp50(found.of(order)[i++])))));
    largest = std::max(largest, std::abs(static_cast<double>(x)));
  }
  return error / largest;
}

TEST(NextToZeros, gradients_of_biharmonic_single_layers_keep_thirteen_digits) {
  EXPECT_LT(relative_error("triangle.biharmonic_single_layer", "hybrid",
                           {{-1, 0, 0}, {1, 0, 0}, {0, 0x1.bb67ae8584caap+0, 0}},
                           {0, 0x1.279a74590331cp-1, 0x1.5798ee2308c3ap-27}, 1),
            1e-13);
  EXPECT_LT(relative_error("triangle.biharmonic_single_layer", "hybrid", {{-1, -1, 2}, {3, 0, 2}, {0, 2, 2}},
                           {0x1.4a0430afd07cap-1, 0x1.68daf4f684860p-2, 0x1.000000019e6bcp+1}, 1),
            1e-13);
}

TEST(NextToZeros, hessians_of_solid_angles_keep_thirteen_digits) {
  EXPECT_LT(relative_error("triangle.solid_angle", "hybrid", {{0, 0, 0}, {3, 0, 0}, {0, 4, 0}},
                           {0x1.ff44005916433p-1, 0x1.1a9c569eb34c1p+0, 0x1.e5c1a004a55a1p-10}, 2),
            1e-13);
}

// Large terms cancel between the two sides of a thin octahedron, so that its sums need the digits of each face's small
// value.
TEST(NextToZeros, faces_of_a_thin_cage_keep_fourteen_digits) {
  const Vec3<double> point{1.3350990963495217, -0.009829443941199192, -0.8712413718314224};
  const std::array parameters{1., 0.25};
  for (const Points& face :
       {Points{{1, 0, 0}, {0, 0.01, 0}, {0, 0, 1}}, Points{{1, 0, 0}, {0, 0, -1}, {0, 0.01, 0}},
        Points{{0, 0, 1}, {0, -0.01, 0}, {1, 0, 0}}, Points{{-1, 0, 0}, {0, 0, -1}, {0, -0.01, 0}}}) {
    EXPECT_LT(relative_error("triangle.kelvin_traction", "hybrid", face, point, 0, parameters), 1e-14);
    EXPECT_LT(relative_error("triangle.biharmonic_double_layer", "hybrid", face, point, 2), 1e-14);
  }
}

TEST(NextToZeros, solid_angles_of_twisted_quads_keep_thirteen_digits) {
  EXPECT_LT(relative_error("quad.solid_angle", "closed_form", {{0, 0, 0}, {2, 0, 1}, {2, 1, 0}, {0, 1, 0}},
                           {0x1.999999999999bp-1, 1.5, -0x1.c70b1c3ce1294p-3}, 0),
            1e-13);
  EXPECT_LT(relative_error(
                "quad.solid_angle", "closed_form",
                {{0, 0, 0}, {0x1.999999999999ap-4, 0, 0}, {0x1.999999999999ap-4, 1, -0x1.2a7c159f8a969p-9}, {0, 1, 0}},
                {-0x1.0441a17d692dcp-6, 0x1.706b4465326bap-3, 0x1.279330ad204dcp-14}, 0),
            1e-13);
}

TEST(NextToZeros, solid_angles_in_the_plane_of_a_quad_are_zero) {
  Result<double> found;
  const Points square{{0, 0, 0.5}, {1, 0, 0.5}, {1, 1, 0.5}, {0, 1, 0.5}};
  evaluation_named("quad.solid_angle", "closed_form")(Query<double>{.corners = square, .point = {3, 0.25, 0.5}}, found);
  EXPECT_EQ(found.value[0], 0);
}

TEST(NextToZeros, potentials_in_the_plane_keep_thirteen_digits) {
  EXPECT_LT(relative_error(
                "segment.biharmonic_single_layer", "hybrid",
                {{0x1.90e73278dc87ep-8, -0x1.edd8e4e23c1d7p-9, 0}, {-0x1.9edb3f23ad6d8p+1, 0x1.ff09138d8ee1fp+0, 0}},
                {-0x1.b38a627db028p-14, -0x1.6191eb6f0b4bp-13, 0}, 0),
            1e-13);
}

// Gradients next to an edge, which a distance of one rounding decides.
// The segment is so nearly a diagonal of the axes that double takes an infinite entry's factor for zero.
TEST(NextToZeros, infinities_at_the_end_of_a_diagonal_keep_their_signs) {
  const Points corners{{-0x1.ffffffd6048c7p+0, 0x1.ffffffeb02464p+1, 0}, {0x1p+2, -0x1p+1, 0}};
  const std::vector<double> biharmonic{2};
  for (const char* formula : {"segment.biharmonic_double_layer", "segment.polyharmonic_double_layer"}) {
    Query<double> query{.corners = corners, .point = corners[0], .order = 2};
    if (formula_named(formula).parameters.size() == 1) query.parameters = biharmonic;
    Result<double> quick, exact;
    evaluation_named(formula, "hybrid")(query, quick);
    evaluation_named(formula, "closed_form")(query, exact);
    ASSERT_TRUE(std::isinf(exact.hessian[1]));
    for (int i = 0; i < 4; ++i) EXPECT_EQ(quick.hessian[i], exact.hessian[i]) << formula << i;
  }
}

TEST(NextToZeros, derivatives_of_quads_solid_angles_next_to_an_edge_keep_thirteen_digits) {
  for (const int order : {1, 2})
    EXPECT_LT(relative_error("quad.solid_angle", "closed_form",
                             {{0.1, 0.2, 0.3}, {1.1, 0.4, 0.2}, {1.2, 1.3, 0.1}, {0.2, 1.1, 0.7}},
                             {0.6 + 1e-15, 0.3, 0.25 + 1e-15}, order),
              1e-13)
        << order;
}

}  // namespace
}  // namespace cageproof::fast
