// SPDX-License-Identifier: MIT
// Elastic bodies of the plane by boundary elements, where their displacements are known.
#include "elastic_truth.h"
#include "support.h"

#include <gtest/gtest.h>

#include <functional>

namespace cageproof::solved::test::elastic_test {
namespace {

using C = std::complex<double>;
constexpr double kMidpoints = 1;  // vertices-and-midpoints, the default

CageCoordinates elastic(const Cage& cage, double nu = 0.3, double pieces = 4, double collocation = kMidpoints) {
  return coordinates(cage, "elastic", {pieces, collocation, nu});
}

// sum E_i u_i.
C displaced(const CageCoordinates& e, const std::function<C(const Vec&)>& u, const Vec& point) {
  const std::vector<double> found = values_at(e, point);
  C sum = 0;
  for (std::size_t v = 0; v < e.elements().vertices().size(); ++v) {
    const C here = u(e.elements().vertices()[v]);
    const double* const m = &found[4 * v];
    sum += C(m[0] * here.real() + m[1] * here.imag(), m[2] * here.real() + m[3] * here.imag());
  }
  return sum;
}

// Where a force (1, 2) at a point displaces others, written by complex numbers: kappa ln r and the force's mirror.
std::function<C(const Vec&)> kelvin(const C& pole, double nu) {
  return [pole, nu](const Vec& p) {
    const C force(1, 2), z = C(p[0], p[1]) - pole;
    return -(3 - 4 * nu) * std::log(std::abs(z)) * force + z * (z * std::conj(force)).real() / std::norm(z);
  };
}

TEST(elastic, affine_displacements_are_kept_by_every_system_of_full_rank) {
  const auto u = [](const Vec& p) { return C(0.5 + 2 * p[0] - p[1], 0.25 * p[0] + 3 * p[1] - 1); };
  for (const double nu : {-0.99, -0.5, 0., 0.3, 0.49})
    for (const Cage& cage : {polygon(triangle), polygon(unit_square), polygon(convex_pentagon), polygon(l_shape),
                             polygon(thin_bar), polygon(hexagon), ring()})
      for (const double collocation : {1., 2., 3.}) {
        const CageCoordinates e = elastic(cage, nu, 2, collocation);
        for (const SolvedSystem& s : e.solved()) EXPECT_FALSE(s.is_singular());
        const auto& v = e.elements().vertices();
        for (const Vec& p :
             {Vec((v[0] + v[1] + v[2]) / 3), v[0], Vec((v[0] + v[1]) / 2), Vec(0.875 * v[1] + 0.125 * v[2])})
          EXPECT_LT(std::abs(displaced(e, u, p) - u(p)), 1e-12 * e.solved()[0].condition) << nu << ' ' << collocation;
      }
}

// Rows of zeros would pass below a bound that grows with the condition.
TEST(elastic, are_conditioned_like_the_harmonic_system) {
  EXPECT_LT(elastic(polygon(unit_square)).solved()[0].condition, 50);
  EXPECT_LT(elastic(polygon(l_shape), -0.9).solved()[0].condition, 100);
  const double near = elastic(polygon(unit_square), 0.5 - 1e-6).solved()[0].condition;
  EXPECT_GT(near, 1e5);
  EXPECT_LT(near, 1e8);
}

// A disc of radius exp(1/(2 kappa)), and a square whose size is near that, are degenerate where the unit is one's own.
TEST(elastic, no_size_is_degenerate) {
  const double expected = elastic(polygon(hexagon)).solved()[0].condition;
  for (double size = 0.5; size < 3; size *= 1.01)
    EXPECT_NEAR(elastic(polygon(hexagon, size)).solved()[0].condition, expected, 1e-6 * expected) << size;
}

TEST(elastic, forces_outside_are_met_to_second_order) {
  for (const double nu : {-0.5, 0.3, 0.45}) {
    const auto u = kelvin(C(-0.75, -0.5), nu);
    const auto error = [&](int parts) {
      const CageCoordinates e = elastic(polygon(subdivided(l_shape, parts)), nu, 1);
      double worst = 0;
      for (const Vec& p : {Vec(0.5, 0.5, 0), Vec(0.25, 1.5, 0), Vec(1.625, 0.375, 0)})
        worst = std::max(worst, std::abs(displaced(e, u, p) - u(p)));
      return worst;
    };
    const double coarse = error(4), fine = error(16);
    EXPECT_LT(coarse, 0.06) << nu;
    EXPECT_LT(fine, coarse / 14) << nu << ' ' << coarse;
    EXPECT_GT(fine, 1e-9) << "a study of errors that has none";
  }
}

// One vertex is displaced, which no polynomial is: Goursat's functions, which know of no layer, have the same interior.
TEST(elastic, pieces_converge_to_goursats_functions) {
  struct Asked {
    const Corners& corners;
    double nu;
    int poles;
    double residual;  // next to the inner corner, where displacements go like r^0.55
  };
  for (const Asked& asked : {Asked{unit_square, -0.5, 20, 1e-7}, Asked{unit_square, 0.3, 20, 1e-7},
                             Asked{unit_square, 0.45, 20, 1e-7}, Asked{l_shape, 0.3, 32, 1e-4}}) {
    std::vector<C> at, values(asked.corners.size(), 0);
    for (const auto& c : asked.corners) at.emplace_back(c[0] / 2, c[1] / 2);
    values[2] = C(1, -0.5);
    values[3] = C(0, 0.5);
    const GoursatElasticity truth(at, values, asked.nu, asked.poles, 16);
    EXPECT_LT(truth.residual(), asked.residual);
    const auto error = [&](double pieces) {
      const CageCoordinates e = elastic(polygon(asked.corners, 0.5), asked.nu, pieces);
      double worst = 0;
      for (const Vec& p : {Vec(0.25, 0.25, 0), Vec(0.125, 0.375, 0), Vec(0.375, 0.0625, 0)}) {
        std::size_t v = 0;
        const C found = displaced(
            e, [&](const Vec&) { return values[v++]; }, p);
        worst = std::max(worst, std::abs(found - truth.displacement(C(p[0], p[1]))));
      }
      return worst;
    };
    const double coarse = error(4), fine = error(32);
    EXPECT_LT(coarse, 3e-3);
    EXPECT_LT(fine, 2e-5);
    EXPECT_LT(fine, coarse / 50);
  }
}

TEST(elastic, are_nearly_the_hat_functions_on_the_border) {
  const CageCoordinates e = elastic(polygon(unit_square), 0.3, 16);
  for (int k = 0; k <= 16; ++k) {
    const double x = k / 16.;
    const std::vector<double> found = values_at(e, Vec(x, 0, 0));
    std::vector<double> hats(16, 0);
    hats[0] = hats[3] = 1 - x, hats[4] = hats[7] = x;
    EXPECT_LT(largest_difference(found, hats), 5e-3) << x;
  }
}

// E of a mirrored cage is E with both indices mirrored.
TEST(elastic, mirror_images_are_mirrored) {
  const Corners pentagon = convex_pentagon;
  Corners mirrored;
  for (auto it = pentagon.rbegin(); it != pentagon.rend(); ++it) mirrored.push_back({-(*it)[0], (*it)[1]});
  const CageCoordinates e = elastic(polygon(pentagon)), m = elastic(polygon(mirrored));
  for (const Vec& p : {Vec(0.75, 0.5, 0), Vec(1, 0, 0), Vec(0, 0, 0)}) {
    const std::vector<double> a = values_at(e, p), b = values_at(m, Vec(-p[0], p[1], 0));
    for (std::size_t v = 0; v < 5; ++v)
      for (std::size_t i = 0; i < 4; ++i)
        EXPECT_NEAR(b[4 * (4 - v) + i], (i == 0 || i == 3 ? 1 : -1) * a[4 * v + i], 1e-13);
  }
}

// E of a turned cage is R E R^t.
TEST(elastic, turns_turn_both_sides) {
  const double c = std::cos(0.6), s = std::sin(0.6);
  Corners turned;
  for (const auto& [x, y] : l_shape) turned.push_back({c * x - s * y, s * x + c * y});
  const CageCoordinates here = elastic(polygon(l_shape)), there = elastic(polygon(turned));
  const Eigen::Matrix2d r{{c, -s}, {s, c}};
  for (const Vec& p : {Vec(0.5, 0.75, 0), Vec(0, 0, 0)}) {
    const std::vector<double> a = values_at(here, p),
                              b = values_at(there, Vec(c * p[0] - s * p[1], s * p[0] + c * p[1], 0));
    for (std::size_t v = 0; v < 6; ++v) {
      const Eigen::Matrix2d expected =
          r * Eigen::Matrix2d{{a[4 * v], a[4 * v + 1]}, {a[4 * v + 2], a[4 * v + 3]}} * r.transpose();
      EXPECT_LT((expected - Eigen::Matrix2d{{b[4 * v], b[4 * v + 1]}, {b[4 * v + 2], b[4 * v + 3]}}).norm(), 1e-12);
    }
  }
}

// Navier's equation, (1 - 2 nu) Laplacian u + grad div u = 0.
TEST(elastic, is_in_equilibrium_inside) {
  const double nu = 0.2;
  const CageCoordinates e = elastic(polygon(l_shape), nu);
  const auto block = e.at<double>(Vec(0.3, 0.7, 0), 2)[0];
  for (std::size_t v = 0; v < 6; ++v)
    for (std::size_t column = 0; column < 2; ++column) {
      const auto second = [&](std::size_t row, std::size_t i, std::size_t j) {
        return block.hessian[4 * (4 * v + 2 * row + column) + 2 * i + j];
      };
      for (std::size_t i = 0; i < 2; ++i)
        EXPECT_NEAR((1 - 2 * nu) * (second(i, 0, 0) + second(i, 1, 1)) + second(0, 0, i) + second(1, 1, i), 0, 1e-12);
    }
}

}  // namespace
}  // namespace cageproof::solved::test::elastic_test
