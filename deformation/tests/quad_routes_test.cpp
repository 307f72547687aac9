// SPDX-License-Identifier: MIT
// Deformers that keep quads against their definitions: plain sums of kernels over bilinear quads, in 50 digits.
#include "quad_cases.h"
#include "quad_corotation_route.h"

#include <gtest/gtest.h>

namespace cageproof::deformation::test::quad_routes_test {
namespace {

// Next to a face plain sums take more points.
constexpr int points_a_side = 48;

Vec as_double(const Mp& column) {
  return {static_cast<double>(column(0, 0)), static_cast<double>(column(1, 0)), static_cast<double>(column(2, 0))};
}

// int g/(4 pi r^3) x' + int 1/(4 pi r) sum Phi_k N^k: values of the posed quad, and what the normals are, at (u, v).
Wide green_route(StretchRoute which, const CageElements& elements, const Case& c, const Wide& eta) {
  Wide image = Wide::Zero();
  for (std::size_t e = 0; e < elements.count(); ++e) {
    const BilinearRoute rest(elements, c.cage.vertices(), e), posed(elements, c.posed, e);
    const std::vector<Wide> normals = neumann_route(which, rest, posed);
    const Mp50 area = rest.is_quad() ? Mp50(1) : length_of(rest.area(0, 0));
    sum_over(rest, points_a_side, [&](const Mp50& u, const Mp50& v, const Mp50& weight) {
      const Wide x = rest.point(u, v) - eta;
      const Mp50 r = length_of(x);
      image += weight * rest.area(u, v).dot(x) / (r * r * r) * posed.point(u, v);
      Wide normal = normals[0];
      const auto basis = rest.basis(u, v);
      if (rest.is_quad()) {
        normal = Wide::Zero();
        for (int k = 0; k < 4; ++k) normal += basis[k] * normals[k];
      }
      image += weight * area / r * normal;
    });
  }
  return image / (4 * pi<Mp50>());
}

TEST(quad_routes, green_is_the_sum_over_posed_quads) {
  for (const Case& c : quad_cases()) {
    const CageElements elements(c.cage, true, Triangulation::Shortest);
    for (const StretchRoute which : {kRms, kMean, kArea, kUnit, kProduct}) {
      const auto found = deformed(*prepared(c.cage, "quad_green", {static_cast<double>(which)}), c.posed, c.points);
      for (const std::size_t p : {0, 1}) {
        const Vec expected = convert<double>(green_route(which, elements, c, convert<Mp50>(c.points[p])));
        EXPECT_LT((image(found, p) - expected).norm() / c.size, 1e-14) << c.name << which << ' ' << p;
      }
    }
  }
}

// What Eq 10 leaves at an image x': sum R_i T_i R_i^t (v'_i - x') + sum R_j K_j R_j^t s'_j m_j, the kernels summed.
Mp residual(const QuadCorotationRoute& route, const CageElements& elements, const Case& c, double nu, const Wide& eta,
            const Vec& image) {
  const Mp50 beta = 1 / (4 * (1 - Mp50(nu)));
  const Mp unit = Mp::Identity(3, 3);
  Mp left = Mp::Zero(3, 1);
  std::size_t first = 0;
  for (std::size_t e = 0; e < elements.count(); ++e) {
    const BilinearRoute rest(elements, c.cage.vertices(), e);
    const auto corners = elements.vertices_of(e);
    const std::size_t facets = rest.is_quad() ? 4 : 1;
    std::vector<Mp> traction(corners.size(), Mp::Zero(3, 3)), displacement(facets, Mp::Zero(3, 3));
    sum_over(rest, points_a_side, [&](const Mp50& u, const Mp50& v, const Mp50& weight) {
      const Mp x = rest.point(u, v) - eta, n = rest.area(u, v);
      const Mp50 r = x.norm(), g = (n.transpose() * x)(0, 0);
      const Mp t = (1 - 2 * beta) / (r * r * r) * (g * unit + n * x.transpose() - x * n.transpose()) +
                   6 * beta * g / (r * r * r * r * r) * x * x.transpose();
      const Mp k = (1 - beta) / r * unit + beta / (r * r * r) * x * x.transpose();
      const auto basis = rest.basis(u, v);
      for (std::size_t i = 0; i < corners.size(); ++i) traction[i] += weight * basis[i] * t;
      for (std::size_t i = 0; i < facets; ++i)
        displacement[i] +=
            weight * (rest.is_quad() ? Mp50(basis[i] * length_of(rest.corner_area(i))) : Mp50(n.norm())) * k;
    });
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const Mp& turn = route.of_vertices[corners[i]];
      left += turn * traction[i] * turn.transpose() * convert<Mp50>(Vec(c.posed[corners[i]] - image));
    }
    for (std::size_t i = 0; i < facets; ++i) {
      const Mp& turn = route.of_facets[first + i];
      left += turn * displacement[i] * turn.transpose() * route.tractions[first + i];
    }
    first += facets;
  }
  return left / (4 * pi<Mp50>());
}

TEST(quad_routes, somigliana_is_in_balance) {
  struct Setting {
    bool local;
    double nu, gamma;
  };
  for (const Case& c : {twisted_cube(), mixed_cage()}) {
    const CageElements elements(c.cage, true, Triangulation::Shortest);
    for (const Setting& s :
         {Setting{false, .3, 0}, Setting{false, .45, 1}, Setting{true, 0, 0}, Setting{true, .3, 2}}) {
      const QuadCorotationRoute route(elements, c.posed, s.local, s.nu, s.gamma);
      const auto deformer = prepared(c.cage, "quad_somigliana", {s.local ? 1. : 0., s.nu, s.gamma, 0, 0.5});
      const auto found = deformed(*deformer, c.posed, c.points);
      const Mp off = residual(route, elements, c, s.nu, convert<Mp50>(c.points[0]), image(found, 0));
      EXPECT_LT(as_double(off).norm() / c.size, 1e-14) << c.name << s.local << ' ' << s.nu << ' ' << s.gamma;
    }
  }
}

// Densities by normal equations, in 50 digits, of layers next to the cage in place of limits.
TEST(quad_routes, densities_of_1_3_are_least_squares_of_the_samples) {
  const Case c = twisted_cube();
  const auto deformer = prepared(c.cage, "quad_biharmonic_1_3", {1, 0, 1, 0});
  const CageCoordinates& layers = deformer->coordinates();
  const CageElements& elements = layers.elements();
  Mp vertices(8, 3), normals(24, 3);
  for (int v = 0; v < 8; ++v) vertices.row(v) = convert<Mp50>(c.posed[v]).transpose();
  for (std::size_t e = 0; e < 6; ++e) {
    const BilinearRoute rest(elements, c.cage.vertices(), e), posed(elements, c.posed, e);
    const auto found = neumann_route(kRms, rest, posed);
    for (int k = 0; k < 4; ++k)
      normals.row(4 * e + k) = (found[k] / Mp50(elements.area_element_of(4 * e + k, Owner::Normal))).transpose();
  }
  NormalEquations equations;
  for (std::size_t e = 0; e < 6; ++e)
    for (const double u : {.25, .75})
      for (const double v : {.25, .75}) {
        const BilinearRoute rest(elements, c.cage.vertices(), e);
        const Wide area = rest.area(u, v);
        const auto at = layers.at<Mp50>(Wide(rest.point(u, v) - Mp50("1e-25") / length_of(area) * area), 0);
        std::array<Mp, 4> of;
        for (std::size_t b = 0; b < 4; ++b) {
          of[b] = Mp::Zero(1, layers.blocks()[b].size);
          for (int i = 0; i < of[b].cols(); ++i) of[b](0, i) = at[b].value[i];
        }
        Mp hats = Mp::Zero(1, 8);
        for (int k = 0; k < 4; ++k) hats(0, elements.vertices_of(e)[k]) = rest.basis(u, v)[k];
        equations.add(side_by_side(of[2], of[3]), hats * vertices - of[0] * vertices - of[1] * normals);
        equations.add(side_by_side(Mp(of[0] - hats), of[1]), Mp::Zero(1, 3));
      }
  const Mp densities = equations.solution();
  const auto images = deformed(*deformer, c.posed, c.points);
  for (std::size_t p = 0; p < c.points.size(); ++p) {
    const auto at = layers.at<double>(c.points[p], 0);
    Vec expected = Vec::Zero();
    const auto add = [&](std::size_t b, const Mp& data) {
      for (int i = 0; i < data.rows(); ++i) expected += at[b].value[i] * as_double(data.row(i).transpose());
    };
    add(0, vertices);
    add(1, normals);
    add(2, densities.topRows(8));
    add(3, densities.bottomRows(24));
    EXPECT_LT((image(images, p) - expected).norm() / c.size, 1e-12) << p;
  }
}

}  // namespace
}  // namespace cageproof::deformation::test::quad_routes_test
