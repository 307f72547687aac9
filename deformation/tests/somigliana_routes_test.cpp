// SPDX-License-Identifier: MIT
// The corotational deformer ([C23] Eq 10-15) against explicit loops in 50 digits.
#include "../src/somigliana/corotation.h"
#include "somigliana_routes.h"

#include <gtest/gtest.h>

namespace cageproof::deformation::test::somigliana_routes_test {
namespace {

struct Setting {
  bool local;
  double nu, gamma;
};

std::vector<Setting> settings() {
  std::vector<Setting> all;
  for (const bool local : {false, true})
    for (const double nu : {0., 0.3, 0.45, static_cast<double>(INFINITY)})
      for (const double gamma : {0., 1., 2.}) all.push_back({local, nu, gamma});
  return all;
}

// What Eq 10 leaves at an image, over the size: sum R_i T_i R_i^t (v'_i - x') + sum R_j K_j R_j^t s'_j m_j.
double residual(const Case& c, const CageCoordinates& coordinates, const CorotationRoute& route, const Vec& point,
                const Vec& image) {
  const int d = c.cage.dimension();
  const auto at = coordinates.at<Mp50>(convert<Mp50>(point), 0);
  const auto block = [&](std::size_t b, std::size_t i) {
    Mp found(d, d);
    for (int k = 0; k < d * d; ++k) found(k / d, k % d) = at[b].value[i * d * d + k];
    return found;
  };
  Mp sum = Mp::Zero(d, 1);
  for (std::size_t v = 0; v < route.of_vertices.size(); ++v) {
    const Mp& r = route.of_vertices[v];
    sum += r * (block(0, v) * (r.transpose() * column(convert<Mp50>(Vec(c.posed[v] - image)), d)));
  }
  for (std::size_t e = 0; e < route.of_elements.size(); ++e) {
    const Mp& r = route.of_elements[e];
    sum += route.balanced[e] * (r * (block(1, e) * (r.transpose() * route.directions[e])));
  }
  return static_cast<double>(Mp50(sum.norm())) / c.size;
}

std::vector<Case> cases() { return {cube(), bar(), square(), l_shape(), pentagon()}; }

TEST(somigliana_routes, images_are_in_balance) {
  for (const Case& c : cases()) {
    for (const Setting& s : settings()) {
      const auto deformer = prepared(c.cage, "somigliana", {s.local ? 1. : 0., s.nu, s.gamma, 0, 0.5});
      const CorotationRoute route(deformer->coordinates().elements(), c.posed, s.local, s.nu, s.gamma);
      const Images<double> found = deformed(*deformer, c.posed, c.points);
      for (std::size_t p = 0; p < c.points.size(); ++p) {
        const double off =
            residual(c, deformer->coordinates(), route, c.points[p], image(found, p, c.cage.dimension()));
        EXPECT_LT(off, 1e-13) << c.name << (s.local ? " local" : " global") << " nu " << s.nu << " gamma " << s.gamma;
      }
    }
  }
}

// The kernels, too, by another route: integrated.
TEST(somigliana_routes, images_are_in_balance_by_integrated_kernels) {
  for (const Case& c : {cube(), l_shape(), pentagon()})
    for (const Setting& s : {Setting{false, .3, 1}, Setting{true, .3, 1}}) {
      const auto deformer = prepared(c.cage, "somigliana", {s.local ? 1. : 0., s.nu, s.gamma, 0, 0.5});
      const CageCoordinates integrated(c.cage, coordinate_kind_named("somigliana"),
                                       CoordinateOptions{.evaluation = "multiprecision", .parameters = {1, s.nu}});
      const CorotationRoute route(integrated.elements(), c.posed, s.local, s.nu, s.gamma);
      const Vec found = image(deformed(*deformer, c.posed, c.points), 0, c.cage.dimension());
      EXPECT_LT(residual(c, integrated, route, c.points[0], found), 1e-13) << c.name << s.local;
    }
}

TEST(somigliana_routes, tractions_are_those_of_the_dense_system_and_balanced) {
  for (const Case& c : cases()) {
    const CageElements elements(c.cage, false, Triangulation::Shortest);
    const int d = c.cage.dimension();
    double worst = 0, turned = 0;
    for (const Setting& s : settings()) {
      const CorotationRoute route(elements, c.posed, s.local, s.nu, s.gamma);
      const CorotationOptions options{.blend = s.local ? 1. : 0., .nu = s.nu, .gamma = s.gamma};
      const Corotation<double> found = corotation_of<double>(elements, c.posed, options);
      Eigen::VectorXd left = Eigen::VectorXd::Zero(d);
      double whole = 0, largest = 0;
      for (const Mp50& traction : route.tractions) largest = std::max(largest, std::abs(static_cast<double>(traction)));
      for (std::size_t e = 0; e < elements.count(); ++e) {
        const Eigen::VectorXd traction = found.tractions[e].head(d),
                              truth = Mp(route.balanced[e] * route.directions[e]).cast<double>();
        keep_larger(worst, (traction - truth).norm() / std::max(1., largest));
        keep_larger(turned, (found.of_normals[e] - route.of_elements[e].cast<double>()).norm());
        const auto measure = static_cast<double>(route.measures[e]);
        left += measure * traction;
        whole += measure * std::abs(static_cast<double>(route.tractions[e]));
      }
      for (std::size_t v = 0; v < c.posed.size(); ++v)
        keep_larger(turned, (found.of_vertices[v] - route.of_vertices[v].cast<double>()).norm());
      EXPECT_LE(left.norm(), 1e-14 * whole) << c.name << s.local << s.nu << s.gamma;
    }
    EXPECT_LT(worst, 1e-13) << c.name;
    EXPECT_LT(turned, 1e-14) << c.name;
  }
}

}  // namespace
}  // namespace cageproof::deformation::test::somigliana_routes_test
