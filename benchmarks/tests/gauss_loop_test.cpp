// SPDX-License-Identifier: MIT
#include "gauss_loop.h"

#include "deformer_benchmarks.h"

#include "cageproof/core/cage/embedded_cages.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace cageproof::benchmarks {
namespace {

// The largest difference in a block over the block's largest number, at every point; blocks of a point lie one after
// the other in `values`.
double difference(const CageCoordinates& coordinates, const std::vector<Vec3<double>>& points,
                  const std::vector<double>& values) {
  const auto tables = coordinates.at<double>(std::span<const Vec3<double>>(points), 0);
  std::size_t width = 0;
  for (const auto& table : tables) width += table.stride[0];
  EXPECT_EQ(values.size(), width * points.size());
  double worst = 0;
  for (std::size_t p = 0; p < points.size(); ++p) {
    const double* found = values.data() + p * width;
    for (const auto& table : tables) {
      double largest = 0, apart = 0;
      for (std::size_t i = 0; i < table.stride[0]; ++i, ++found) {
        const double expected = table.tensors[0][p * table.stride[0] + i];
        largest = std::max(largest, std::abs(expected));
        const double d = std::abs(*found - expected);
        apart = std::isfinite(d) ? std::max(apart, d) : HUGE_VAL;
      }
      worst = std::max(worst, apart / largest);
    }
  }
  return worst;
}

// Nodes of another order than quadrature_ref's, the same sums.
TEST(GaussLoop, sums_what_the_rule_of_quadrature_sums) {
  // Quads that are split, and lanes without a point.
  const DeformedCage in = embedded_deformed_cage("twisted-bar", 67);
  for (const char* name : {"green", "biharmonic", "somigliana"})
    for (const GaussRule& rule : {collapsed_rule(4), collapsed_rule(8), collapsed_rule(20), three_quad_rule(5)}) {
      SCOPED_TRACE(std::string(name) + ' ' + rule.name);
      const CoordinateKind& kind = coordinate_kind_named(name);
      ASSERT_TRUE(GaussLoop::exists(kind, in.cage));
      const GaussLoop loop(in.cage, kind, rule);
      const CageCoordinates expected(in.cage, kind, rule.name, Triangulation::Shortest);
      // Numbers that stand there before must not count.
      std::vector<double> values(in.points.size() * loop.entries(), 1e300);
      loop.fill_on_vectors(in.points, values);
      EXPECT_LT(difference(expected, in.points, values), 1e-12) << "on vectors";
      std::ranges::fill(values, 1e300);
      loop.fill_plainly(in.points, values);
      EXPECT_LT(difference(expected, in.points, values), 1e-12) << "plainly";
    }
}

// Farther from the cage than its triangles are large, where the rule converges like 10^-N at least.
TEST(GaussLoop, nears_the_closed_form) {
  const DeformedCage in = embedded_deformed_cage("icosphere", 24);
  std::vector<Vec3<double>> far;
  far.reserve(in.points.size());
  for (const Vec3<double>& p : in.points) far.push_back(3 * in.cage.size() * p.normalized());
  for (const char* name : {"green", "biharmonic", "somigliana"}) {
    SCOPED_TRACE(name);
    const CoordinateKind& kind = coordinate_kind_named(name);
    const CageCoordinates recommended(in.cage, kind, CoordinateOptions{});
    for (const auto& [side, bound] : {std::pair{4, 1e-4}, {8, 1e-8}, {20, 1e-11}}) {
      const GaussLoop loop(in.cage, kind, collapsed_rule(side));
      std::vector<double> values(far.size() * loop.entries());
      loop.fill_on_vectors(far, values);
      EXPECT_LT(difference(recommended, far, values), bound) << side;
    }
  }
}

TEST(GaussLoop, rules_have_as_many_nodes_as_they_say_and_integrate_basis_functions) {
  EXPECT_EQ(collapsed_rule(20).weights.size(), 400U);
  EXPECT_EQ(three_quad_rule(50).weights.size(), 7500U);
  EXPECT_EQ(three_quad_rule(50).name, "three-quad-7500");
  for (const GaussRule& rule : {collapsed_rule(4), three_quad_rule(50)})
    for (int k = 0; k < 3; ++k) {
      double sum = 0;
      for (std::size_t n = 0; n < rule.weights.size(); ++n) sum += rule.weights[n] * rule.hats[3 * n + k];
      EXPECT_NEAR(sum, 1.0 / 6, 1e-14) << rule.name;
    }
}

TEST(GaussLoop, exists_in_space_for_three_kinds) {
  EXPECT_FALSE(GaussLoop::exists(coordinate_kind_named("mean_value"), embedded_cage("cube")));
  EXPECT_FALSE(GaussLoop::exists(coordinate_kind_named("green"), embedded_cage("square")));
}

}  // namespace
}  // namespace cageproof::benchmarks
