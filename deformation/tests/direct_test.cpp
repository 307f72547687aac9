// SPDX-License-Identifier: MIT
// The four layers with densities of the user's own ([T24] Eq 19), and what rows of them are refused.
#include "regularised_routes.h"

#include "cageproof/core/input_error.h"
#include "cageproof/deformation/stretch.h"

#include <gtest/gtest.h>

namespace cageproof::deformation::test {
namespace {

std::vector<Vec> rest_normals(const Deformer<double>& deformer) { return deformer.coordinates().elements().normals(); }

// The trace of f's Hessian, of the first point of the case.
Vec laplacian(const Case& c, const std::vector<Vec>& laplacians, const std::vector<Vec>& derivatives) {
  const auto deformer = prepared(c.cage, "biharmonic_direct");
  const auto posed =
      deformer->pose({.vertices = c.posed, .laplacians = laplacians, .laplacian_derivatives = derivatives});
  const Images<double> images = deformer->images(*posed, std::span(c.points), 2);
  const int d = c.cage.dimension();
  Vec found = Vec::Zero();
  for (int i = 0; i < d; ++i)
    for (int a = 0; a < d; ++a) found[i] += images.tensors[2][i * d * d + a * d + a];
  return found;
}

TEST(direct, laplacian_of_vertices_and_normals_is_the_point_and_of_ones_is_one) {
  for (const Case& c : {cube(), bar(), l_shape(), pentagon()}) {
    const auto normals = rest_normals(*prepared(c.cage, "biharmonic_direct"));
    EXPECT_LT((laplacian(c, c.cage.vertices(), normals) - c.points[0]).norm(), 1e-12) << c.name;
    const Vec ones = c.cage.dimension() == 2 ? Vec(1, 1, 0) : Vec(1, 1, 1);
    EXPECT_LT((laplacian(c, std::vector<Vec>(c.posed.size(), ones), {}) - ones).norm(), 1e-12) << c.name;
    EXPECT_LT(laplacian(c, {}, {}).norm(), 1e-12) << c.name;
  }
}

TEST(direct, is_green_without_densities_and_biharmonic_1_3_with_its_own) {
  for (const Case& c : {cube(), l_shape(), pentagon()}) {
    const int d = c.cage.dimension();
    const auto deformer = prepared(c.cage, "biharmonic_direct");
    const Images<double> plain = deformed(*deformer, c.posed, c.points),
                         green = deformed(*prepared(c.cage, "green", {3}), c.posed, c.points),
                         regularised = deformed(*prepared(c.cage, "biharmonic_1_3"), c.posed, c.points);
    const CageElements& elements = deformer->coordinates().elements();
    const std::vector<Vec> normals = stretched_normals(Stretch::Unit, elements, c.posed);
    const auto in_50_digits = [&](const std::vector<Vec>& rows) {
      Mp found(rows.size(), d);
      for (std::size_t i = 0; i < rows.size(); ++i)
        for (int k = 0; k < d; ++k) found(static_cast<int>(i), k) = Mp50(rows[i][k]);
      return found;
    };
    const Mp densities = densities_by_constraints("regularised_1_3", deformer->coordinates(), in_50_digits(c.posed),
                                                  in_50_digits(normals));
    Pose<double> pose{.vertices = c.posed};
    for (int i = 0; i < densities.rows(); ++i) {
      Vec row = Vec::Zero();
      for (int k = 0; k < d; ++k) row[k] = static_cast<double>(densities(i, k));
      (i < static_cast<int>(c.posed.size()) ? pose.laplacians : pose.laplacian_derivatives).push_back(row);
    }
    const auto posed = deformer->pose(pose);
    const Images<double> images = deformer->images(*posed, std::span(c.points), 0);
    for (std::size_t i = 0; i < images.tensors[0].size(); ++i) {
      EXPECT_NEAR(plain.tensors[0][i], green.tensors[0][i], 1e-14 * c.size) << c.name;
      EXPECT_NEAR(images.tensors[0][i], regularised.tensors[0][i], 1e-12 * c.size) << c.name;
    }
  }
}

TEST(direct, rows_are_refused_by_number) {
  const Case c = cube();
  const auto refusal = [&](const char* method, const Pose<double>& pose) -> std::string {
    try {
      prepared(c.cage, method)->pose(pose);
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  };
  const std::vector<Vec> few(3, Vec::Zero());
  std::vector<Vec> lost(12, Vec::Zero()), of_vertices(8, Vec::Zero());
  lost[5][1] = NAN;
  of_vertices[6][2] = INFINITY;
  for (const char* method : {"green", "biharmonic_1_3", "biharmonic_1_2", "biharmonic_weber", "biharmonic_direct"}) {
    EXPECT_EQ(refusal(method, {.vertices = c.posed, .normal_derivatives = few}),
              "there are 3 normal derivatives, the rest cage has 12 elements")
        << method;
    EXPECT_EQ(refusal(method, {.vertices = c.posed, .normal_derivatives = lost}),
              "row 5 of the normal derivatives is not finite")
        << method;
  }
  EXPECT_EQ(refusal("biharmonic_direct", {.vertices = c.posed, .laplacians = few}),
            "there are 3 Laplacians, the rest cage has 8 vertices");
  EXPECT_EQ(refusal("biharmonic_direct", {.vertices = c.posed, .laplacians = of_vertices}),
            "row 6 of the Laplacians is not finite");
  EXPECT_EQ(refusal("biharmonic_direct", {.vertices = c.posed, .laplacian_derivatives = few}),
            "there are 3 normal derivatives of Laplacians, the rest cage has 12 elements");
}

}  // namespace
}  // namespace cageproof::deformation::test
