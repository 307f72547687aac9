// SPDX-License-Identifier: MIT
// Harmonic coordinates by boundary elements, where they are known.
#include "support.h"

#include <gtest/gtest.h>

#include <numeric>

namespace cageproof::solved::test::harmonic_test {
namespace {

constexpr int kCollocations = 4;

TEST(harmonic, are_barycentric_coordinates_in_triangles) {
  const Cage cage = polygon(triangle);
  for (const double pieces : {1, 2, 5})
    for (int c = 1; c < kCollocations; ++c) {
      const CageCoordinates h = coordinates(cage, "harmonic", {pieces, static_cast<double>(c)});
      for (const Vec& p : {Vec(0.375, 0.25, 0), Vec(0.5, 0, 0), Vec(1e-8, 1e-9, 0), Vec(0.25, 0.75, 0)}) {
        // x = b + c/4, y = 3/4 c of the corners' weights a, b, c.
        const double third = p[1] / 0.75, second = p[0] - third / 4;
        EXPECT_LT(largest_difference(values_at(h, p), {1 - second - third, second, third}), 1e-13);
      }
    }
}

// In the unit square bilinear functions are harmonic, and linear on edges. Their normal derivatives are linear on
// edges, too; constants on pieces miss them to second order, which leaves errors of fourth order inside.
TEST(harmonic, converge_to_bilinear_functions_in_the_square) {
  const auto error = [](double pieces) {
    const CageCoordinates h = coordinates(polygon(unit_square), "harmonic", {pieces, 1});
    double worst = 0;
    for (const Vec& p : {Vec(0.5, 0.5, 0), Vec(0.25, 0.375, 0), Vec(0.75, 0.8125, 0)}) {
      const double x = p[0], y = p[1];
      worst =
          std::max(worst, largest_difference(values_at(h, p), {(1 - x) * (1 - y), x * (1 - y), x * y, (1 - x) * y}));
    }
    return worst;
  };
  const double coarse = error(4), fine = error(32);
  EXPECT_LT(coarse, 1e-3);
  EXPECT_LT(fine, coarse / 1000);
  EXPECT_LT(fine, 1e-7);
  EXPECT_GT(fine, 1e-9) << "a study of errors that has none";
}

TEST(harmonic, have_affine_precision_wherever_the_system_has_full_rank) {
  for (const Cage& cage : {polygon(unit_square), polygon(convex_pentagon), polygon(l_shape), polygon(thin_bar), ring()})
    for (const double pieces : {1, 4})
      for (int c = 1; c < kCollocations; ++c) {
        const CageCoordinates h = coordinates(cage, "harmonic", {pieces, static_cast<double>(c)});
        for (const SolvedSystem& s : h.solved()) EXPECT_FALSE(s.is_singular());
        for (const Vec& p : {Vec(0.25, 0.0078125, 0), Vec(0, 0, 0), Vec(0.5, 0, 0)})
          EXPECT_LT(affine_errors(h, p, 0)[0], 1e-12);
      }
}

// The least solution of the singular system lacks the part of the normals that alternates from edge to edge: the
// report says that the system is singular.
TEST(harmonic, lose_affine_precision_by_the_singular_square_system) {
  const CageCoordinates h = coordinates(polygon(l_shape), "harmonic", {1, 0});
  ASSERT_EQ(h.solved().size(), 1u);
  EXPECT_TRUE(h.solved()[0].is_singular());
  EXPECT_GT(affine_errors(h, Vec(0.25, 0.5, 0), 0)[0], 1e-3);
  const std::vector<double> values = values_at(h, Vec(0.25, 0.5, 0));
  EXPECT_NEAR(std::accumulate(values.begin(), values.end(), 0.0), 1, 1e-12);
}

TEST(harmonic, are_nearly_the_hat_functions_on_the_boundary) {
  const CageCoordinates h = coordinates(polygon(unit_square), "harmonic", {16, 1});
  for (int k = 0; k <= 16; ++k) {
    const double x = k / 16.;
    EXPECT_LT(largest_difference(values_at(h, Vec(x, 0, 0)), {1 - x, x, 0, 0}), 1e-3) << x;
  }
}

// Where pieces meet the density jumps, and the gradient grows like the distance's logarithm; also on edges of
// directions in which no node is exactly what it should be.
TEST(harmonic, have_no_gradient_where_pieces_meet) {
  const CageCoordinates h = coordinates(polygon(convex_pentagon), "harmonic", {4, 1});
  for (const Vec& middle :
       {Vec(1, 0, 0), Vec(2.25, 0.625, 0), Vec(1.75, 1.625, 0), Vec(0.25, 1.5, 0), Vec(-0.25, 0.5, 0)})
    EXPECT_TRUE(std::ranges::none_of(h.at<double>(middle, 1)[0].gradient, [](double x) { return std::isfinite(x); }))
        << middle.transpose();
}

TEST(harmonic, are_harmonic) {
  for (const auto& block : coordinates(polygon(l_shape), "harmonic").at<double>(Vec(0.3, 0.7, 0), 2))
    for (std::size_t i = 0; i < block.value.size(); ++i)
      EXPECT_NEAR(block.hessian[4 * i] + block.hessian[4 * i + 3], 0, 1e-12);
}

}  // namespace
}  // namespace cageproof::solved::test::harmonic_test
