// SPDX-License-Identifier: MIT
// The coordinates of the L by finite differences, which know no function of the basis and no corner.
#include "cageproof/core/coordinates/coordinates.h"
#include "goursat_polygons.h"

#include <gtest/gtest.h>

#include <Eigen/SparseCholesky>

namespace cageproof::solved::goursat {
namespace {

// A coordinate of l_shape(): values at the boundary's nodes, and outward derivatives, by position.
struct Wanted {
  double (*value)(double x, double y);
  double (*slope)(double x, double y);
};

// The biharmonic equation by its thirteen points, or the harmonic one by its five, on a grid of n intervals a unit.
std::vector<double> by_differences(const Wanted& wanted, bool biharmonic, int n, std::span<const Vec3<double>> points) {
  const auto inside = [n](int i, int j) { return i > 0 && j > 0 && i < 2 * n && j < 2 * n && (i < n || j < n); };
  std::vector<int> number((2 * n + 1) * (2 * n + 1), -1);
  int count = 0;
  for (int i = 0; i <= 2 * n; ++i)
    for (int j = 0; j <= 2 * n; ++j)
      if (inside(i, j)) number[i * (2 * n + 1) + j] = count++;
  const double h = 1.0 / n;
  std::vector<Eigen::Triplet<double>> entries;
  Eigen::VectorXd right = Eigen::VectorXd::Zero(count);
  for (int i = 1; i < 2 * n; ++i)
    for (int j = 1; j < 2 * n; ++j) {
      if (!inside(i, j)) continue;
      const int row = number[i * (2 * n + 1) + j];
      const auto add = [&](int p, int q, double weight) {
        if (inside(p, q)) entries.emplace_back(row, number[p * (2 * n + 1) + q], weight);
        else right[row] -= weight * wanted.value(p * h, q * h);
      };
      add(i, j, biharmonic ? 20 : 4);
      for (const auto& [a, b] : {std::pair{1, 0}, {-1, 0}, {0, 1}, {0, -1}}) {
        add(i + a, j + b, biharmonic ? -8 : -1);
        if (!biharmonic) continue;
        add(i + a - b, j + b + a, 2);
        if (inside(i + a, j + b)) {
          add(i + 2 * a, j + 2 * b, 1);
        } else {  // beyond the boundary: what the derivative there makes of the node itself
          entries.emplace_back(row, row, 1);
          right[row] -= 2 * h * wanted.slope((i + a) * h, (j + b) * h);
        }
      }
    }
  Eigen::SparseMatrix<double> system(count, count);
  system.setFromTriplets(entries.begin(), entries.end());
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factors(system);
  const Eigen::VectorXd u = factors.solve(right);
  std::vector<double> found;
  for (const Vec3<double>& p : points)
    found.push_back(u[number[static_cast<int>(p[0] * n) * (2 * n + 1) + static_cast<int>(p[1] * n)]]);
  return found;
}

// From four grids, whose errors have terms with these powers of the width.
std::vector<double> extrapolated(const Wanted& wanted, bool biharmonic, std::span<const Vec3<double>> points,
                                 std::span<const double> powers) {
  std::vector<std::vector<double>> u;
  for (const int n : {16, 32, 64, 128}) u.push_back(by_differences(wanted, biharmonic, n, points));
  for (const double power : powers) {
    const double factor = std::pow(2, power);
    for (std::size_t k = 0; k + 1 < u.size(); ++k)
      for (std::size_t p = 0; p < points.size(); ++p) u[k][p] = (factor * u[k + 1][p] - u[k][p]) / (factor - 1);
    u.pop_back();
  }
  return u.back();
}

double zero(double, double) { return 0; }

}  // namespace

TEST(goursat_differences, agree_on_the_l) {
  // The hat function of the notch's corner (1, 1), and the derivative on the edge from (2, 1) to it.
  const Wanted alpha{[](double x, double y) { return y == 1 && x > 1 ? 2 - x : x == 1 && y >= 1 ? 2 - y : 0; }, zero};
  const Wanted beta{zero, [](double x, double y) { return y == 1 && x > 1 && x < 2 ? 1.0 : 0.0; }};
  const Cage cage = l_shape();
  const CageCoordinates goursat(cage, coordinate_kind_named("biharmonic_goursat"), CoordinateOptions{});
  const CageCoordinates harmonic(cage, coordinate_kind_named("harmonic_goursat"), CoordinateOptions{});
  const std::vector<Vec3<double>> points{{0.5, 0.5, 0}, {1.25, 0.5, 0}, {0.75, 0.75, 0}, {0.375, 1.5, 0}};
  // The first exponents of the notch's corner, where differences converge as slowly as the solution is smooth.
  constexpr std::array clamped{0.5445, 0.9085, 1.0889};
  constexpr std::array free{4.0 / 3, 2.0};
  const auto alphas = extrapolated(alpha, true, points, clamped), betas = extrapolated(beta, true, points, clamped);
  const auto lambdas = extrapolated(alpha, false, points, free);
  for (std::size_t p = 0; p < points.size(); ++p) {
    const auto found = goursat.at<double>(points[p], 0);
    EXPECT_NEAR(found[0].value[3], alphas[p], 2e-4) << points[p].transpose();
    EXPECT_NEAR(found[1].value[2], betas[p], 2e-4) << points[p].transpose();
    EXPECT_NEAR(harmonic.at<double>(points[p], 0)[0].value[3], lambdas[p], 1e-5) << points[p].transpose();
  }
}

}  // namespace cageproof::solved::goursat
