// SPDX-License-Identifier: MIT
// Normal derivatives that are affine on elements ([T24] Eq 41-43): against quadrature of their definition, against the
// constraints one by one, and what they share with constant ones.
#include "somigliana_routes.h"

#include "cageproof/core/numbers/gauss_legendre.h"
#include "cageproof/core/input_error.h"
#include "cageproof/deformation/stretch.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace cageproof::deformation::test {
namespace {

struct Method {
  std::string_view name, kind;
  std::vector<double> affine, constant;
};
const std::vector<Method> methods{{"biharmonic_1_3", "regularised_1_3", {1, 3, 1, 0, 1}, {1, 3, 1, 0, 0}},
                                  {"biharmonic_1_2", "regularised_1_2", {1, 3, 1}, {1, 3, 0}},
                                  {"biharmonic_weber", "regularised_weber", {1, 3, 1}, {1, 3, 0}}};

// Some normal derivatives, three per triangle or two per segment.
std::vector<Vec> some_normals(const Case& c) {
  const CageElements elements(c.cage, false, Triangulation::Shortest);
  std::vector<Vec> found;
  for (std::size_t i = 0; i < elements.count(Owner::Corner); ++i) {
    const auto x = static_cast<double>(i);
    const Vec step(std::sin(1 + x), std::cos(2 * x), c.cage.dimension() == 3 ? std::sin(3 + 5 * x) : 0);
    found.push_back(elements.normals()[elements.element_of(i, Owner::Corner)] + step / 4);
  }
  return found;
}

Images<double> with_normals(const Case& c, const Deformer<double>& deformer, const std::vector<Vec>& normals) {
  const auto posed = deformer.pose({.vertices = c.posed, .normal_derivatives = normals});
  return deformer.images(*posed, std::span<const Vec>(c.points), 0);
}

// sum over elements of int G sum_k Gamma_k n^k, with the Green function's sign of psi, by a product of Gauss rules.
Vec by_quadrature(const CageElements& elements, const std::vector<Vec>& normals, const Vec& point) {
  const auto& rule = gauss_legendre<double>(40);
  Vec sum = Vec::Zero();
  for (std::size_t e = 0; e < elements.count(); ++e) {
    const auto c = elements.corners(e);
    const auto n = elements.shares_of(e, Owner::Corner);
    for (std::size_t i = 0; i < rule.nodes.size(); ++i) {
      const double u = rule.nodes[i];
      if (c.size() == 2) {
        const double r = (c[0] + u * (c[1] - c[0]) - point).norm();
        sum -= rule.weights[i] * (c[1] - c[0]).norm() * std::log(r) / (2 * M_PI) *
               ((1 - u) * normals[n[0]] + u * normals[n[1]]);
        continue;
      }
      for (std::size_t j = 0; j < rule.nodes.size(); ++j) {
        const double v = (1 - u) * rule.nodes[j];
        const double r = (c[0] + u * (c[1] - c[0]) + v * (c[2] - c[0]) - point).norm();
        sum += rule.weights[i] * rule.weights[j] * (1 - u) * (c[1] - c[0]).cross(c[2] - c[0]).norm() / (4 * M_PI * r) *
               ((1 - u - v) * normals[n[0]] + u * normals[n[1]] + v * normals[n[2]]);
      }
    }
  }
  return sum;
}

TEST(affine, normal_derivatives_are_integrated_as_defined) {
  for (const Case& c : {cube(), bar(), l_shape(), pentagon()}) {
    const auto deformer = prepared(c.cage, "biharmonic_direct", {3, 1});
    const std::vector<Vec> normals = some_normals(c), none(normals.size(), Vec::Zero());
    const Images<double> with = with_normals(c, *deformer, normals), without = with_normals(c, *deformer, none);
    // The bar's third point is next to a face, where the rule is not accurate.
    for (std::size_t p = 0; p < std::min<std::size_t>(2, c.points.size()); ++p) {
      const int d = c.cage.dimension();
      const Vec expected = by_quadrature(deformer->coordinates().elements(), normals, c.points[p]);
      EXPECT_LT((image(with, p, d) - image(without, p, d) - expected).norm(), 1e-12 * c.size) << c.name << p;
    }
  }
}

TEST(affine, densities_are_those_of_the_constraints) {
  for (const Case& c : {cube(), l_shape(), pentagon()}) {
    const CageCoordinates layers(c.cage, coordinate_kind_named("biharmonic_affine"), CoordinateOptions{});
    const int d = c.cage.dimension();
    const auto rows = [&](const std::vector<Vec>& points) {
      Mp found(points.size(), d);
      for (std::size_t i = 0; i < points.size(); ++i)
        for (int k = 0; k < d; ++k) found(static_cast<int>(i), k) = points[i][k];
      return found;
    };
    const std::vector<Vec> normals = some_normals(c);
    for (const Method& method : methods) {
      const Mp densities = densities_by_constraints(method.kind, layers, rows(c.posed), rows(normals));
      const auto n = static_cast<Eigen::Index>(c.posed.size());
      const Images<double> images = with_normals(c, *prepared(c.cage, method.name, method.affine), normals);
      for (std::size_t p = 0; p < c.points.size(); ++p) {
        const auto at = layers.at<Mp50>(convert<Mp50>(c.points[p]), 0);
        const auto times = [](const std::vector<Mp50>& row, const Mp& data) {
          return Mp(Eigen::Map<const Mp>(row.data(), 1, static_cast<Eigen::Index>(row.size())) * data);
        };
        const Mp expected = times(at[0].value, rows(c.posed)) + times(at[1].value, rows(normals)) +
                            times(at[2].value, densities.topRows(n)) +
                            times(at[3].value, densities.bottomRows(densities.rows() - n));
        for (int k = 0; k < d; ++k)
          EXPECT_NEAR(static_cast<double>(expected(0, k)), image(images, p, d)[k], 1e-11 * c.size)
              << c.name << ' ' << method.name;
      }
    }
  }
}

TEST(affine, normal_derivatives_that_are_equal_are_constant_ones) {
  for (const Case& c : {cube(), bar(), l_shape()}) {
    const int d = c.cage.dimension();
    const CageElements elements(c.cage, false, Triangulation::Shortest);
    std::vector<Vec> normals, corners;
    for (std::size_t e = 0; e < elements.count(); ++e) {
      normals.push_back(posed_normal(elements, c.posed, e));
      corners.insert(corners.end(), elements.vertices_of(e).size(), normals.back());
    }
    for (const Method& method : methods) {
      const Images<double> affine = with_normals(c, *prepared(c.cage, method.name, method.affine), corners),
                           constant = with_normals(c, *prepared(c.cage, method.name, method.constant), normals);
      for (std::size_t p = 0; p < c.points.size(); ++p)
        EXPECT_LT((image(affine, p, d) - image(constant, p, d)).norm(), 1e-12 * c.size) << c.name << method.name;
    }
  }
}

// The method's own data bend with the cage, and are constant where the pose is a rotation.
TEST(affine, keeps_rigid_maps_and_with_stretched_normals_similarities_and_is_another_method) {
  for (const Case& c : {cube(), bar(), l_shape(), pentagon()}) {
    const int d = c.cage.dimension();
    const Vec axis = d == 3 ? Vec(Vec(1, 2, -1).normalized()) : Vec(Vec::UnitZ());
    for (Method method : methods)
      for (const double scale : {1.0, 1.5}) {
        const Eigen::Matrix3d map = scale * Eigen::AngleAxisd(0.7, axis).toRotationMatrix();
        std::vector<Vec> posed;
        for (const Vec& v : c.cage.vertices()) posed.emplace_back(map * v + Vec(1, 2, 0));
        method.affine[1] = 0;
        const Images<double> found = deformed(*prepared(c.cage, method.name, method.affine), posed, c.points);
        for (std::size_t p = 0; p < c.points.size(); ++p)
          EXPECT_LT((image(found, p, d) - map * c.points[p] - Vec(1, 2, 0)).norm(), 1e-12 * c.size)
              << c.name << method.name << scale;
      }
    const Images<double> affine = deformed(*prepared(c.cage, "biharmonic_1_3", methods[0].affine), c.posed, c.points),
                         constant =
                             deformed(*prepared(c.cage, "biharmonic_1_3", methods[0].constant), c.posed, c.points);
    EXPECT_GT((image(affine, 0, d) - image(constant, 0, d)).norm(), 1e-4 * c.size) << c.name;
    EXPECT_LT((image(affine, 0, d) - image(constant, 0, d)).norm(), 1e-1 * c.size) << c.name;
  }
}

// The rest normal turned by the rotation of each vertex, which is found by another route, and as long as `normals`
// says.
TEST(affine, own_normal_derivatives_turn_with_the_vertices) {
  for (const Case& c : {cube(), bar(), l_shape(), pentagon()}) {
    const int d = c.cage.dimension();
    const CageElements elements(c.cage, false, Triangulation::Shortest);
    const CorotationRoute route(elements, c.posed, true, 0.3, 0);
    for (const bool stretched : {false, true}) {
      std::vector<Vec> normals;
      for (std::size_t e = 0; e < elements.count(); ++e)
        for (const int v : elements.vertices_of(e)) {
          const Mp turned = route.of_vertices[v] * column(convert<Mp50>(elements.normals()[e]), d);
          Vec normal = Vec::Zero();
          for (int k = 0; k < d; ++k) normal[k] = static_cast<double>(turned(k, 0));
          normals.emplace_back(normal * (stretched ? static_cast<double>(route.stretches[e]) : 1));
        }
      // Stretches of the route are means.
      const auto deformer = prepared(c.cage, "biharmonic_1_3", {1, stretched ? 1.0 : 3.0, 1, 0, 1});
      const Images<double> own = deformed(*deformer, c.posed, c.points), given = with_normals(c, *deformer, normals);
      for (std::size_t p = 0; p < c.points.size(); ++p)
        EXPECT_LT((image(own, p, d) - image(given, p, d)).norm(), 1e-13 * c.size) << c.name << stretched;
      if (c.cage.vertices().size() > 8) continue;
      std::vector<Vec3<Mp50>> posed;
      posed.reserve(c.posed.size());
      for (const Vec& v : c.posed) posed.push_back(convert<Mp50>(v));
      const auto exact = prepare_deformer<Mp50>(deform_method_named("biharmonic_1_3"), c.cage,
                                                {.parameters = {1, stretched ? 1.0 : 3.0, 1, 0, 1}});
      const Images<Mp50> in_50_digits = deformed<Mp50>(*exact, posed, {convert<Mp50>(c.points[0])});
      for (int k = 0; k < d; ++k)
        EXPECT_NEAR(static_cast<double>(in_50_digits.tensors[0][k]), image(own, 0, d)[k], 1e-13 * c.size) << c.name;
    }
  }
}

TEST(affine, refuses_a_row_an_element) {
  const Case c = cube();
  const auto deformer = prepared(c.cage, "biharmonic_1_3", methods[0].affine);
  try {
    deformer->pose({.vertices = c.posed, .normal_derivatives = std::vector<Vec>(12, Vec::UnitX())});
    FAIL() << "took a row an element";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("36 corners of elements"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace cageproof::deformation::test
