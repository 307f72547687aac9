// SPDX-License-Identifier: MIT
// How near the boundary elements come to biharmonic functions that are known, and how fast.
#include "support.h"

#include <gtest/gtest.h>

namespace cageproof::solved::test::convergence_test {
namespace {

constexpr double kVertices = 0, kDefault = 1;

const std::vector<Vec> inside{{0.5, 0.5, 0}, {0.25, 0.375, 0}, {0.75, 0.8125, 0}};

// Errors of every manufactured function, whose data are given at the vertices and middles of every edge's n parts.
std::vector<double> errors_of_all(const Corners& corners, int n) {
  return largest_errors(coordinates(polygon(subdivided(corners, n)), "biharmonic_boundary", {1, kDefault}),
                        manufactured(), inside);
}

// Exact boundary data of functions that are smooth up to the corners; normal derivatives are constant on parts, and so
// no more than first order is to be expected near the boundary. Inside it is between h^1.2 and h^2.
TEST(convergence, to_known_biharmonic_functions_is_of_first_order_at_least) {
  for (const Corners* corners : {&unit_square, &convex_pentagon, &l_shape}) {
    const auto coarse = errors_of_all(*corners, 8), fine = errors_of_all(*corners, 32);
    for (std::size_t k = 0; k < coarse.size(); ++k) {
      EXPECT_LT(fine[k], coarse[k] / 4) << manufactured()[k].name;
      EXPECT_LT(fine[k], 0.015) << manufactured()[k].name;
      EXPECT_GT(fine[k], 1e-5) << manufactured()[k].name << ": a study of errors that has none";
    }
  }
}

// Pieces interpolate the data linearly between vertices: a function that is not linear on edges stays where it was.
TEST(convergence, needs_data_between_the_vertices) {
  const Goursat& f = manufactured()[0];
  const CageCoordinates c = coordinates(polygon(unit_square), "biharmonic_boundary", {32, kDefault});
  EXPECT_GT(std::abs(interpolated(c, f.data(c.elements()), inside[0]) - f.value(inside[0])), 0.05);
}

struct True {
  const Corners& corners;
  Vec point;
  std::vector<double> alpha, beta;
};

// The biharmonic functions with these boundary values (Eq 8), by least squares in a basis of Goursat functions with
// poles clustered at the corners, an implementation of its own; two bases agree to 1e-13, the boundary values to 2e-13.
const std::vector<True> true_coordinates{
    {unit_square,
     {0.25, 0.5, 0},
     {0.4165429803354, 0.0834570196645, 0.0834570196645, 0.4165429803354},
     {-0.0333197859056, -0.0167420931481, -0.0333197859056, -0.0998280538190}},
    {unit_square,
     {0.125, 0.25, 0},
     {0.7203846388733, 0.0546926795125, 0.0056623699192, 0.2192603116951},
     {-0.0276835423225, -0.0022747679550, -0.0026062239387, -0.0669197185233}},
    {convex_pentagon,
     {0.5, 0.5, 0},
     {0.5429441016015, 0.1868530805431, 0.0082918590569, 0.0960512378537, 0.1658597209449},
     {-0.1779525068116, -0.0054674092862, -0.0171167277655, -0.0771474488700, -0.0697433004504}},
    {convex_pentagon,
     {2, 1.25, 0},
     {0.0044698153721, 0.0671355321580, 0.6897376042898, 0.2381087424568, 0.0005483057234},
     {-0.0084545239655, -0.0455573000303, -0.1251231000749, -0.0029758079522, -0.0001736270469}}};

// The largest errors of alpha and beta at the points in polygons of these corners.
std::array<double, 2> errors_at(const Corners& corners, double pieces) {
  const CageCoordinates c = coordinates(polygon(corners), "biharmonic_boundary", {pieces, kDefault});
  std::array<double, 2> worst{};
  for (const True& t : true_coordinates) {
    if (&t.corners != &corners) continue;
    const auto found = c.at<double>(t.point, 0);
    worst[0] = std::max(worst[0], largest_difference(found[0].value, t.alpha));
    worst[1] = std::max(worst[1], largest_difference(found[1].value, t.beta));
  }
  return worst;
}

// The scheme's own error: a Laplacian that is singular at corners is taken to be linear on pieces. 48 of them an edge
// leave half a percent and more.
TEST(convergence, leaves_percents_of_the_true_biharmonic_coordinates) {
  for (const Corners* corners : {&unit_square, &convex_pentagon}) {
    const auto coarse = errors_at(*corners, 1), fine = errors_at(*corners, 48);
    EXPECT_LT(fine[0], 2.6e-2);
    EXPECT_GT(fine[0], 4e-3);
    EXPECT_LT(fine[1], 4e-2);
    EXPECT_LT(fine[0], coarse[0] / 2);
  }
}

// What Eq 7 asks, at vertices and at points within the edges, limits from inside.
struct Hermite {
  double alpha_at_vertices = 0, beta_on_boundary = 0;
  double normal_derivatives = 0;       // the largest error
  double mean_normal_derivatives = 0;  // in the square
};

Hermite hermite(const Corners& corners, double pieces) {
  const CageCoordinates c = coordinates(polygon(corners), "biharmonic_boundary", {pieces, kDefault});
  Hermite found;
  const int m = static_cast<int>(corners.size());
  for (int v = 0; v < m; ++v) {
    const auto at = c.at<double>(c.elements().vertices()[v], 0);
    for (int j = 0; j < m; ++j) {
      found.alpha_at_vertices = std::max(found.alpha_at_vertices, std::abs(at[0].value[j] - (j == v ? 1 : 0)));
      found.beta_on_boundary = std::max(found.beta_on_boundary, std::abs(at[1].value[j]));
    }
  }
  int count = 0;
  for (int e = 0; e < m; ++e)
    for (int k = 1; k < 64; k += 2) {
      const auto ends = c.elements().corners(e);
      const Vec n = c.elements().normals()[e];
      const auto at = c.at<double>(Vec(ends[0] + k / 64. * (ends[1] - ends[0])), 1);
      for (int j = 0; j < m; ++j)
        for (int b = 0; b < 2; ++b) {
          const double along = at[b].gradient[2 * j] * n[0] + at[b].gradient[2 * j + 1] * n[1];
          const double error = std::abs(along - (b == 1 && j == e ? 1 : 0));
          found.normal_derivatives = std::max(found.normal_derivatives, error);
          found.mean_normal_derivatives += error * error;
          ++count;
          if (b == 1) found.beta_on_boundary = std::max(found.beta_on_boundary, std::abs(at[1].value[j]));
        }
    }
  found.mean_normal_derivatives = std::sqrt(found.mean_normal_derivatives / count);
  return found;
}

// Points are sixty-fourths of edges between integers: exactly on the cage.
TEST(convergence, to_the_hermite_property_is_first_order_for_values_and_slow_for_normal_derivatives) {
  for (const Corners* corners : {&unit_square, &l_shape}) {
    const Hermite coarse = hermite(*corners, 4), fine = hermite(*corners, 32);
    EXPECT_LT(fine.alpha_at_vertices, coarse.alpha_at_vertices / 8);
    EXPECT_LT(fine.beta_on_boundary, coarse.beta_on_boundary / 8);
    EXPECT_LT(fine.mean_normal_derivatives, coarse.mean_normal_derivatives / 2);
    // At the points next to corners nothing is gained.
    EXPECT_GT(fine.normal_derivatives, 0.2);
    EXPECT_LT(fine.normal_derivatives, 0.6);
  }
}

// The square system, where it is regular, interpolates at the vertices themselves.
TEST(convergence, is_not_needed_at_the_vertices_by_the_square_system) {
  const CageCoordinates c = coordinates(polygon(convex_pentagon), "biharmonic_boundary", {3, kVertices});
  for (int v = 0; v < 5; ++v) {
    const auto at = c.at<double>(c.elements().vertices()[v], 0);
    for (int j = 0; j < 5; ++j) {
      EXPECT_NEAR(at[0].value[j], j == v ? 1 : 0, 1e-12);
      EXPECT_NEAR(at[1].value[j], 0, 1e-12);
    }
  }
}

// The Laplacian of alpha and beta, from their Hessians, has the mean value property.
TEST(biharmonic_boundary, has_a_harmonic_laplacian) {
  const CageCoordinates c = coordinates(polygon(l_shape), "biharmonic_boundary", {3, kDefault});
  const Vec centre(0.6, 0.55, 0);
  const auto laplacians = [&](const Vec& p) {
    std::vector<double> all;
    for (const auto& block : c.at<double>(p, 2))
      for (std::size_t i = 0; i < block.value.size(); ++i)
        all.push_back(block.hessian[4 * i] + block.hessian[4 * i + 3]);
    return all;
  };
  const std::vector<double> expected = laplacians(centre);
  std::vector<double> mean(expected.size());
  // A harmonic function's mean over 64 points of a circle errs by (radius / distance to the boundary)^64.
  constexpr int points = 64;
  for (int k = 0; k < points; ++k) {
    const double angle = 2 * 3.14159265358979 * k / points;
    const auto here = laplacians(centre + 0.2 * Vec(std::cos(angle), std::sin(angle), 0));
    for (std::size_t i = 0; i < mean.size(); ++i) mean[i] += here[i] / points;
  }
  EXPECT_LT(largest_difference(mean, expected), 1e-12);
  EXPECT_GT(*std::ranges::max_element(expected), 0.1);
}

}  // namespace
}  // namespace cageproof::solved::test::convergence_test
