// SPDX-License-Identifier: MIT
// Aligned normal derivatives ([T24] Eq 31-36) against normal equations as printed, of second differences in 100 digits.
#include "aligned_routes.h"
#include "least_over_sets.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace cageproof::deformation::test::aligned_routes_test {
namespace {

enum Alignment { kHard, kSoft, kFree, kNonNegative };

constexpr std::array methods{std::pair{"ahap", Operator::Laplacian}, std::pair{"aaap", Operator::Hessian},
                             std::pair{"tp", Operator::Normal}};

Mp rows(const std::vector<Vec>& points, int d) {
  Mp found(static_cast<int>(points.size()), d);
  for (int i = 0; i < found.rows(); ++i)
    for (int c = 0; c < d; ++c) found(i, c) = Mp50(points[i][c]);
  return found;
}

Mp posed_units(const CageElements& elements, const std::vector<Vec>& posed) {
  const int d = elements.dimension();
  Mp found(static_cast<int>(elements.count()), d);
  for (std::size_t e = 0; e < elements.count(); ++e) {
    std::vector<Vec3<Mp50>> corners;
    for (const int v : elements.vertices_of(e)) corners.push_back(convert<Mp50>(posed[v]));
    found.row(static_cast<int>(e)) = unit_normal(corners).head(d).transpose();
  }
  return found;
}

struct Expected {
  Mp normals, sigma;  ///< no sigma of alignments without
};

Expected expected(const AlignedRoute& route, Alignment alignment, const Mp& vertices, const Mp& units, double gamma_a) {
  if (alignment == kSoft) return {route.softly(vertices, units, Mp50(gamma_a)), {}};
  if (alignment == kFree) return {route.softly(vertices, units, Mp50(0)), {}};
  const auto [matrix, right] = route.along(vertices, units);
  const Mp sigma =
      alignment == kNonNegative ? least_not_negative(matrix, right) : Mp(Eigen::FullPivLU<Mp>(matrix).solve(right));
  return {sigma.reshaped().asDiagonal() * units, sigma};
}

// The largest distance of images from those of a pose's vertices and normal derivatives, in sizes.
double distance(const Case& c, const Images<double>& images, const CageCoordinates& layers, const AlignedRoute& route,
                const Mp& vertices, const Mp& normals) {
  const int d = c.cage.dimension();
  Mp data(vertices.rows() + normals.rows(), d);
  data << vertices, normals;
  Mp all(2 * data.rows(), d);
  all << data, route.densities * data;
  double worst = 0;
  for (std::size_t p = 0; p < c.points.size(); ++p) {
    const auto at = layers.at<Mp50>(convert<Mp50>(c.points[p]), 0);
    for (int k = 0; k < d; ++k) {
      Mp50 sum = -Mp50(images.tensors[0][p * d + k]);
      int row = 0;
      for (const auto& block : at)
        for (const Mp50& value : block.value) sum += value * all(row++, k);
      keep_larger(worst, std::abs(static_cast<double>(sum)));
    }
  }
  return worst / c.size;
}

void expect_route(const Case& c, const char* method, const CageCoordinates& layers, const AlignedRoute& route) {
  const int d = c.cage.dimension();
  const Mp vertices = rows(c.posed, d), units = posed_units(layers.elements(), c.posed);
  const double samples = (d == 3 ? 4. : 2.) * static_cast<double>(layers.elements().count());
  for (const Alignment alignment : {kHard, kSoft, kFree, kNonNegative}) {
    // Sets of columns are twice as many with each element.
    if (alignment == kNonNegative && units.rows() > 12) continue;
    const double gamma_a = 3;
    const auto deformer = prepared(c.cage, method, {1, 1, static_cast<double>(alignment), gamma_a, 1});
    const auto posed = deformer->pose({c.posed, {}});
    const DeformationReport& report = posed->report();
    const Expected truth = expected(route, alignment, vertices, units, gamma_a);
    const double condition = std::max(1e3, report.systems.at(0).condition),
                 off = distance(c, deformer->images(*posed, std::span(c.points), 0), layers, route, vertices,
                                truth.normals);
    // Section 11: 1e-13 of the size where the condition is no more than 1e3, else 1e-16 times it.
    EXPECT_LT(off, 1e-16 * condition) << c.name << ' ' << method << ' ' << alignment;
    const auto expect_figure = [&](const char* name, const Mp50& value) {
      const auto number = static_cast<double>(value);
      EXPECT_NEAR(figure(report, name), number, 1e-15 * condition * (1 + std::abs(number)))
          << c.name << ' ' << method << ' ' << alignment << ' ' << name;
    };
    expect_figure("energy a sample", route.energy(vertices, truth.normals) / samples);
    if (alignment != kFree) expect_figure("energy a sample, unit normals", route.energy(vertices, units) / samples);
    if (truth.sigma.size() == 0) continue;
    expect_figure("least sigma", truth.sigma.minCoeff());
    expect_figure("largest sigma", truth.sigma.maxCoeff());
    const auto count = [&](auto&& is) { return std::ranges::count_if(truth.sigma.reshaped(), is); };
    if (alignment == kHard)
      EXPECT_EQ(figure(report, "negative sigma"), count([](const Mp50& s) { return s < 0; })) << c.name << method;
    else EXPECT_EQ(figure(report, "zero sigma"), count([](const Mp50& s) { return s == 0; })) << c.name << method;
  }
}

TEST(aligned_routes, of_the_cube_the_bar_and_polygons) {
  for (const Case& c : {cube(), bar(), l_shape(), pentagon()}) {
    const CageCoordinates layers(c.cage, coordinate_kind_named("biharmonic"), CoordinateOptions{});
    const SecondDerivatives derivatives(layers);
    for (const auto& [method, op] : methods) expect_route(c, method, layers, AlignedRoute(op, layers, derivatives));
  }
}

}  // namespace
}  // namespace cageproof::deformation::test::aligned_routes_test
