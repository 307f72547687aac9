// SPDX-License-Identifier: MIT
// Green deformers by loops over layers that are integrated in many digits, with stretches as they are printed.
#include "regularised_routes.h"

#include <Eigen/Eigenvalues>

#include <gtest/gtest.h>

namespace cageproof::deformation::test::green_routes_test {
namespace {

using Wide = Vec3<Mp50>;

enum Stretch { kRms, kMean, kArea, kUnit };

Mp50 length(const Wide& v) { return sqrt(Mp50(v.dot(v))); }

// Two edges of a triangle, or the one of a segment and the axis across the plane.
std::array<Wide, 2> edges(const CageElements& elements, const std::vector<Vec>& vertices, std::size_t e) {
  const auto corners = elements.vertices_of(e);
  const Wide first = convert<Mp50>(vertices[corners[0]]);
  return {convert<Mp50>(vertices[corners[1]]) - first,
          corners.size() == 2 ? Wide(0, 0, 1) : Wide(convert<Mp50>(vertices[corners[2]]) - first)};
}

// Coordinates of a triangle's edges in an orthonormal frame of its plane, the edges' columns.
Mp flat(const std::array<Wide, 2>& edges) {
  const Wide along = edges[0] / length(edges[0]);
  const Wide across = edges[1] - along.dot(edges[1]) * along;
  Mp found(2, 2);
  found << along.dot(edges[0]), along.dot(edges[1]), 0, length(across);
  return found;
}

Mp50 stretch(Stretch which, const std::array<Wide, 2>& rest, const std::array<Wide, 2>& posed, int d) {
  if (which == kUnit) return 1;
  if (d == 2) return length(posed[0]) / length(rest[0]);
  const auto& [u, v] = rest;
  const auto& [u_posed, v_posed] = posed;
  const Mp50 area = length(u.cross(v)) / 2;
  if (which == kRms)  // Lipman et al. 2008
    return sqrt(Mp50(u_posed.dot(u_posed) * v.dot(v) - 2 * u_posed.dot(v_posed) * u.dot(v) +
                     v_posed.dot(v_posed) * u.dot(u))) /
           (sqrt(Mp50(8)) * area);
  if (which == kArea) return sqrt(Mp50(length(u_posed.cross(v_posed)) / 2 / area));
  const Mp map = flat(posed) * Eigen::FullPivLU<Mp>(flat(rest)).inverse();
  const Mp squares = Eigen::SelfAdjointEigenSolver<Mp>(Mp(map.transpose() * map)).eigenvalues();
  return (sqrt(squares(0, 0)) + sqrt(squares(1, 0))) / 2;
}

// phi V' + psi N', N'_t = s_t n'_t.
Mp image_by_loops(const Case& c, Stretch which, const std::vector<Result<Mp50>>& layers, const CageElements& elements) {
  const int d = c.cage.dimension();
  Wide sum = Wide::Zero();
  for (std::size_t v = 0; v < c.posed.size(); ++v) sum += layers[0].value[v] * convert<Mp50>(c.posed[v]);
  for (std::size_t e = 0; e < elements.count(); ++e) {
    const auto posed = edges(elements, c.posed, e);
    const Wide normal = posed[0].cross(posed[1]);
    sum +=
        layers[1].value[e] * stretch(which, edges(elements, c.cage.vertices(), e), posed, d) / length(normal) * normal;
  }
  return sum.head(d);
}

TEST(green_routes, images_are_sums_over_integrated_layers) {
  for (const Case& c : {cube(), bar(), square(), l_shape(), pentagon()}) {
    const int d = c.cage.dimension();
    const CageCoordinates integrated(c.cage, coordinate_kind_named("green"),
                                     CoordinateOptions{.evaluation = "multiprecision"});
    const auto layers = integrated.at<Mp50>(convert<Mp50>(c.points[0]), 0);
    for (const Stretch which : {kRms, kMean, kArea, kUnit}) {
      const Images<double> found =
          deformed(*prepared(c.cage, "green", {static_cast<double>(which)}), c.posed, c.points);
      const Mp expected = image_by_loops(c, which, layers, integrated.elements());
      EXPECT_LT((image(found, 0, d).head(d) - expected.cast<double>()).norm() / c.size, 1e-14) << c.name << which;
    }
  }
}

}  // namespace
}  // namespace cageproof::deformation::test::green_routes_test
