// SPDX-License-Identifier: MIT
// Quantities that rules are planned with: norms, zeros of r^2, nearest points, numbers of nodes and cells.
#include "../src/rules/elementary.h"
#include "../src/rules/gauss_nodes.h"
#include "../src/rules/panels.h"
#include "../src/rules/quad/closest_point.h"
#include "../src/rules/quad/polynomial_zeros.h"
#include "../src/rules/triangle/polar_cells.h"

#include "cageproof/core/numbers/random_stream.h"

#include <gtest/gtest.h>

#include <numbers>

namespace cageproof::quadrature_ref {
namespace {

using Vec = Vec3<double>;

TEST(Planning, log10_norm_is_that_of_the_root_of_the_squares) {
  EXPECT_NEAR(log10_norm(std::vector<Mp50>{Mp50(3), Mp50(-4)}), std::log10(5), 1e-15);
  EXPECT_NEAR(log10_norm(std::vector<Mp200>{Mp200("6e-500"), Mp200("8e-500")}), -499, 1e-12);
}

TEST(Planning, polynomial_zeros_of_every_size) {
  using Complex = std::complex<double>;
  const std::vector<std::array<Complex, 4>> cases{
      {Complex(.5, 2), Complex(.5, -2), Complex(-3), Complex(.25)},
      {Complex(1e-8, 1e-9), Complex(1e-8, -1e-9), Complex(40, 1), Complex(40, -1)},
      {Complex(0, 1e-12), Complex(0, -1e-12), Complex(1, 1e-3), Complex(1, -1e-3)}};
  for (const auto& zeros : cases) {
    std::array<Complex, 5> product{1};
    for (int i = 0; i < 4; ++i)
      for (int k = i + 1; k >= 0; --k) product[k] = (k > 0 ? product[k - 1] : 0.) - zeros[i] * product[k];
    std::array<double, 5> coefficients{};
    for (int k = 0; k < 5; ++k) coefficients[k] = product[k].real();
    const std::vector<Complex> found = polynomial_zeros(coefficients);
    ASSERT_EQ(found.size(), 4U);
    for (const Complex& zero : zeros) {
      double nearest = HUGE_VAL;
      for (const Complex& z : found) nearest = std::min(nearest, std::abs(z - zero) / std::abs(zero));
      EXPECT_LT(nearest, 1e-8) << zero;
    }
  }
}

// Off a point inside along the normal nothing is nearer, unless the quad bends back: these do not.
TEST(Planning, closest_point_is_the_foot_of_the_normal) {
  for (int i = 0; i < 20; ++i) {
    RandomStream random(5, "closest point", i);
    const auto noise = [&] { return Vec(random.uniform(-.2, .2), random.uniform(-.2, .2), random.uniform(-.2, .2)); };
    const Quad<double> quad{Vec(0, 0, 0) + noise(), Vec(1, 0, 0) + noise(), Vec(1, 1, 0) + noise(),
                            Vec(0, 1, 0) + noise()};
    std::array<Vec3<Mp200>, 4> q;
    for (int k = 0; k < 4; ++k) q[k] = cageproof::convert<Mp200>(quad[k]);
    const Mp200 u = random.uniform(.1, .9), v = random.uniform(.1, .9);
    const Vec3<Mp200> along_u = (1 - v) * (q[1] - q[0]) + v * (q[2] - q[3]),
                      along_v = (1 - u) * (q[3] - q[0]) + u * (q[2] - q[1]);
    const Mp200 distance(i % 2 == 0 ? .125 : 1e-9);
    const Vec3<Mp200> point = (1 - v) * ((1 - u) * q[0] + u * q[1]) + v * ((1 - u) * q[3] + u * q[2]) +
                              distance * along_u.cross(along_v).normalized();
    const auto frame = quad_frame<Mp200>(q, point);
    ASSERT_TRUE(frame);
    const ClosestPoint found = closest_point(*frame);
    EXPECT_LT(abs(Mp200(found.u - u)), 1e-60) << i;
    EXPECT_LT(abs(Mp200(found.v - v)), 1e-60) << i;
  }
}

// The integrand is exp(4 x), the fastest growth that plans assume.
TEST(Planning, nodes_are_enough_and_not_many_more) {
  for (const double length : {.5, 2., 8.})
    for (const double digits : {8., 16., 32.}) {
      const Mp100 truth = (1 - exp(Mp100(-4 * length))) / 4;  // over [-length, 0], where the integrand's maximum is 1
      int least = 1;
      const auto error = [&](int n) {
        const GaussNodes<Mp100>& rule = gauss_nodes<Mp100>(n);
        Mp100 sum = -truth;
        for (int i = 0; i < n; ++i) sum += length * rule.weights[i] * exp(Mp100(4 * length * (rule.nodes[i] - 1)));
        return abs(sum);
      };
      while (error(least) > pow(Mp100(10), Mp100(-digits))) ++least;
      const int planned = nodes_for(-length, 0, {}, digits);
      EXPECT_GE(planned, least) << length << ' ' << digits;
      EXPECT_LE(planned, 1.25 * least + 2) << length << ' ' << digits;
    }
}

// Cells end at the edge: the longer the way there, the more of them.
TEST(Planning, no_polar_cell_is_longer_than_its_rule_can_carry) {
  const Singularities radial{{0, std::numbers::pi / 2}, {-std::asinh(1), 0}};
  const std::array<Vec3<Mp200>, 3> corners{cageproof::convert<Mp200>(Vec(0, 0, 0)),
                                           cageproof::convert<Mp200>(Vec(1, 0, 0)),
                                           cageproof::convert<Mp200>(Vec(0, 1, 0))};
  std::size_t reaching = 0;
  for (const double height : {1., 1e-2, 1e-8})
    for (const Vec& foot : {Vec(.25, .25, 0), Vec(.5, -.25, 0), Vec(2, 2, 0)})
      for (const PanelDesign& design : {PanelDesign{4, 4}, PanelDesign{8, 8}, PanelDesign{12, 15}}) {
        const auto triangle = lined_triangle(corners, cageproof::convert<Mp200>(Vec(foot + Vec(0, 0, height))));
        std::vector<PolarCell> cells;
        set_polar_cells(polar_frame(*triangle, Mp200(0)), design, cells);
        for (const PolarCell& cell : cells) {
          const double whole = cell.w_hi - cell.w_lo;
          const double from = cell.reaches_edge ? cell.w_lo + cell.lower * whole : cell.w_lo,
                       to = cell.reaches_edge ? cell.w_lo + cell.upper * whole : cell.w_hi;
          EXPECT_LE(nodes_for(from, to, radial, design.digits), design.nodes) << height << ' ' << foot.transpose();
          reaching += cell.reaches_edge;
        }
      }
  EXPECT_GT(reaching, 81U);
}

}  // namespace
}  // namespace cageproof::quadrature_ref
