// SPDX-License-Identifier: MIT
// The plane's solved deformers ([W12] Eq 17-20) by another route: Green layers of the divided polygon next to it in
// place of limits, and normal equations in 50 digits in place of pseudo-inverses.
#include "least_over_sets.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace cageproof::deformation::test {
namespace {

enum Normals { kUnit, kComplex, kAhap };

Mp least_squares(const Mp& matrix, const Mp& right) {
  return Eigen::FullPivLU<Mp>(matrix.transpose() * matrix).solve(matrix.transpose() * right);
}

// Each edge in so many pieces.
Cage divided(const Cage& cage, int pieces) {
  std::vector<Vec> nodes;
  std::vector<Face> segments;
  const int n = static_cast<int>(cage.vertices().size());
  for (int e = 0; e < n; ++e)
    for (int k = 0; k < pieces; ++k) {
      const double along = static_cast<double>(k) / pieces;
      nodes.emplace_back((1 - along) * cage.vertices()[e] + along * cage.vertices()[(e + 1) % n]);
      segments.push_back({{e * pieces + k, (e * pieces + k + 1) % (n * pieces), -1, -1}});
    }
  return Cage::make_polygon("divided", nodes, segments, {});
}

struct BoundaryRoute {
  CageCoordinates layers;
  Mp to_nodes, to_pieces;            ///< U_f, U_d
  Mp slopes, of_values, of_normals;  ///< A, B, C

  BoundaryRoute(const Cage& cage, int pieces)
      : layers(divided(cage, pieces), coordinate_kind_named("biharmonic"), CoordinateOptions{}) {
    const CageElements& elements = layers.elements();
    const int m = static_cast<int>(elements.count()), n = m / pieces;
    to_nodes = to_pieces = Mp::Zero(m, n);
    for (int k = 0; k < m; ++k) {
      const Mp50 along = Mp50(k % pieces) / pieces;
      to_nodes(k, k / pieces) += 1 - along;
      to_nodes(k, (k / pieces + 1) % n) += along;
      to_pieces(k, k / pieces) = 1;
    }
    Mp hats = Mp::Zero(2 * m, m);
    std::array<Mp, 4> of;
    for (Mp& one : of) one = Mp::Zero(2 * m, m);
    for (int k = 0; k < m; ++k)
      for (const int half : {0, 1}) {
        const int row = 2 * k + half;
        hats(row, k) = half == 0 ? Mp50(1) : Mp50(0.5);
        if (half == 1) hats(row, (k + 1) % m) = Mp50(0.5);
        const auto at = layers.at<Mp50>(next_to(k, half), 0);
        for (std::size_t b = 0; b < 4; ++b)
          for (int i = 0; i < m; ++i) of[b](row, i) = at[b].value[i];
      }
    slopes = least_squares(of[1], hats - of[0]);
    const Mp of_laplacians = of[2] + of[3] * slopes;
    of_values = least_squares(of_laplacians, hats - of[0]);
    of_normals = least_squares(of_laplacians, -of[1]);
  }

  // A node, or the middle of the piece after it, 1e-32 inside.
  Vec3<Mp50> next_to(int k, int half) const {
    const CageElements& elements = layers.elements();
    const int m = static_cast<int>(elements.count());
    const auto ends = elements.corners(k);
    Vec outward = elements.normals()[k];
    if (half == 0) outward += elements.normals()[(k + m - 1) % m];
    const Vec3<Mp50> from = convert<Mp50>(ends[0]), to = convert<Mp50>(ends[1]);
    return (half == 0 ? from : Vec3<Mp50>((from + to) / Mp50(2))) - Mp50("1e-32") * convert<Mp50>(outward);
  }

  Mp laplacians(const Mp& posed, const Mp& normals) const {
    return of_values * (to_nodes * posed) + of_normals * (to_pieces * normals);
  }
  Mp image(const Vec& point, const Mp& posed, const Mp& normals) const {
    const auto at = layers.at<Mp50>(convert<Mp50>(point), 0);
    const auto row = [&](std::size_t b) {
      Mp found(1, static_cast<int>(at[b].value.size()));
      for (int i = 0; i < found.cols(); ++i) found(0, i) = at[b].value[i];
      return found;
    };
    const Mp values = to_nodes * posed, pulls = to_pieces * normals, laplacian = laplacians(posed, normals);
    return row(0) * values + row(1) * pulls + row(2) * laplacian + row(3) * (slopes * laplacian);
  }
};

// The outward normals that least Laplacians are made by.
Mp least_laplacians(const BoundaryRoute& route, const Mp& posed, const Mp& units) {
  const Mp part = route.of_normals * route.to_pieces, fixed = route.laplacians(posed, Mp::Zero(units.rows(), 2));
  const Mp gram = (part.transpose() * part).cwiseProduct(units * units.transpose());
  const Mp stretches = least_not_negative(gram, -Mp(part.transpose() * fixed).cwiseProduct(units).rowwise().sum());
  return stretches.col(0).asDiagonal() * units;
}

TEST(boundary_routes, images_and_laplacians_are_those_of_normal_equations) {
  for (const Case& c : {square(), l_shape(), pentagon()})
    for (const int pieces : {1, 2, 4}) {
      const BoundaryRoute route(c.cage, pieces);
      const int n = static_cast<int>(c.posed.size());
      Mp posed(n, 2), units(n, 2), stretched(n, 2);
      for (int e = 0; e < n; ++e) {
        const Vec3<Mp50> edge = convert<Mp50>(c.posed[(e + 1) % n]) - convert<Mp50>(c.posed[e]);
        const Vec3<Mp50> rest = convert<Mp50>(c.cage.vertices()[(e + 1) % n]) - convert<Mp50>(c.cage.vertices()[e]);
        const Mp50 length = sqrt(Mp50(edge.dot(edge)));
        posed.row(e) << Mp50(c.posed[e][0]), Mp50(c.posed[e][1]);
        units.row(e) << Mp50(edge[1] / length), Mp50(-edge[0] / length);
        stretched.row(e) = units.row(e) * length / sqrt(Mp50(rest.dot(rest)));
      }
      for (const Normals which : {kUnit, kComplex, kAhap}) {
        const Mp normals = which == kUnit      ? units
                           : which == kComplex ? stretched
                                               : least_laplacians(route, posed, units);
        const auto deformer =
            prepared(c.cage, "biharmonic_boundary", {static_cast<double>(which), static_cast<double>(pieces), 1, 1});
        const auto found = deformer->pose({c.posed});
        const Mp expected = route.image(c.points[0], posed, normals);
        const Vec at = image(deformer->images(*found, c.points, 0), 0, 2);
        for (int k = 0; k < 2; ++k)
          EXPECT_NEAR(at[k], static_cast<double>(expected(0, k)), 1e-13 * c.size) << c.name << pieces << which;
        const auto sum = static_cast<double>(Mp50(route.laplacians(posed, normals).squaredNorm()));
        EXPECT_NEAR(figure(found->report(), "sum of squared Laplacians"), sum, 1e-12 * sum)
            << c.name << pieces << which;
      }
    }
}

}  // namespace
}  // namespace cageproof::deformation::test
