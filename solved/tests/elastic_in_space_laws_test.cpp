// SPDX-License-Identifier: MIT
// Elastic coordinates in space turn with the cage, in every scalar, and so do their derivatives and their limits.
#include "cageproof/core/cage/embedded_cages.h"
#include "cageproof/core/input_error.h"
#include "elastic_space_support.h"

#include <gtest/gtest.h>

namespace cageproof::solved::test::elastic_in_space_laws_test {
namespace {

// A block of triangles, because a quad's diagonal may change when the cage turns.
Cage elastic_block() { return split_cage(embedded_cage("l-block"), 0); }

Cage mapped(const Cage& cage, const Eigen::Matrix3d& map, const Vec& offset) {
  std::vector<Vec> vertices;
  for (const Vec& v : cage.vertices()) vertices.push_back(map * v + offset);
  std::vector<Face> faces = cage.faces();
  if (map.determinant() < 0)
    for (Face& f : faces) std::swap(f.vertices[1], f.vertices[2]);
  return Cage::make("mapped", vertices, faces);
}

Eigen::Matrix3d matrix_of(const std::vector<double>& entries, std::size_t vertex) {
  Eigen::Matrix3d found;
  for (std::size_t k = 0; k < 9; ++k)
    found(static_cast<Eigen::Index>(k / 3), static_cast<Eigen::Index>(k % 3)) = entries[9 * vertex + k];
  return found;
}

// E of a mapped cage is R E R^t, R the map without its scale.
void expect_turned(const Eigen::Matrix3d& map, const Vec& offset, double tolerance) {
  const CageCoordinates here = elastic_at_level(elastic_block(), 0, 0.3),
                        there = elastic_at_level(mapped(elastic_block(), map, offset), 0, 0.3);
  const Eigen::Matrix3d r = map / std::cbrt(std::abs(map.determinant()));
  for (const Vec& p : inner_points(here.elements(), 3)) {
    const std::vector<double> a = values_at(here, p), b = values_at(there, map * p + offset);
    for (std::size_t v = 0; v < a.size() / 9; ++v)
      EXPECT_LT((r * matrix_of(a, v) * r.transpose() - matrix_of(b, v)).cwiseAbs().maxCoeff(), tolerance) << v;
  }
}

TEST(elastic_in_moved_cages, matrices_turn_mirror_and_have_no_unit) {
  const Eigen::Matrix3d one = Eigen::Matrix3d::Identity();
  const Eigen::Matrix3d turn =
      (Eigen::AngleAxisd(0.7, Vec(1, 2, -1).normalized()) * Eigen::AngleAxisd(1.1, Vec(0, 1, 3).normalized()))
          .toRotationMatrix();
  expect_turned(one, Vec(64, -32, 16), 1e-13);
  expect_turned(turn, Vec::Zero(), 1e-13);
  expect_turned(Eigen::Vector3d(-1, -1, 1).asDiagonal(), Vec::Zero(), 1e-13);
  expect_turned(Eigen::Vector3d(-1, 1, 1).asDiagonal(), Vec::Zero(), 1e-13);
  for (const double unit : {1e-90, 3., 1e90}) expect_turned(unit * one, Vec::Zero(), 1e-13);
}

// Navier's equation, (1 - 2 nu) Laplacian u + grad div u = 0.
TEST(elastic_in_space, is_in_equilibrium_inside) {
  const double nu = 0.2;
  const CageCoordinates e = elastic_at_level(embedded_cage("cube"), 1, nu);
  const auto block = e.at<double>(Vec(0.3, -0.2, 0.125), 2)[0];
  for (std::size_t v = 0; v < 8; ++v)
    for (std::size_t column = 0; column < 3; ++column) {
      const auto second = [&](std::size_t row, std::size_t i, std::size_t j) {
        return block.hessian[9 * (9 * v + 3 * row + column) + 3 * i + j];
      };
      for (std::size_t i = 0; i < 3; ++i)
        EXPECT_NEAR((1 - 2 * nu) * (second(i, 0, 0) + second(i, 1, 1) + second(i, 2, 2)) + second(0, 0, i) +
                        second(1, 1, i) + second(2, 2, i),
                    0, 1e-11);
    }
}

TEST(elastic_in_every_scalar, have_its_digits) {
  const CageCoordinates e = elastic_at_level(embedded_cage("cube"), 0, 0.3);
  // Inside, on a face, an edge and at a vertex.
  for (const Vec& p : {Vec(0.1, 0.2, 0.3), Vec(0.5, 0.25, -0.125), Vec(0.5, 0.5, 0.125), Vec(0.5, 0.5, 0.5)}) {
    const auto fifty = e.at<Mp50>(convert<Mp50>(p), 0)[0].value;
    const auto twice = e.at<double>(p, 0)[0].value;
    const auto single = e.at<float>(convert<float>(p), 0)[0].value;
    for (std::size_t i = 0; i < fifty.size(); ++i) {
      EXPECT_NEAR(twice[i], static_cast<double>(fifty[i]), 1e-13) << p.transpose();
      EXPECT_NEAR(single[i], twice[i], 1e-6);
    }
  }
  EXPECT_TRUE(e.is_exact_in(ScalarKind::Digits50));
  EXPECT_FALSE(e.is_exact_in(ScalarKind::Digits100));
}

TEST(elastic_in_every_scalar, have_the_derivatives_of_their_values) {
  const CageCoordinates e = elastic_at_level(embedded_cage("cube"), 0, 0.3);
  const Mp100 step("1e-30");
  const Vec3<Mp100> point(Mp100("0.14"), Mp100("-0.22"), Mp100("0.31"));
  const auto found = e.at<Mp100>(point, 2)[0];
  for (int a = 0; a < 3; ++a) {
    Vec3<Mp100> plus = point, minus = point;
    plus[a] += step;
    minus[a] -= step;
    const auto up = e.at<Mp100>(plus, 1)[0], down = e.at<Mp100>(minus, 1)[0];
    for (int o = 1; o <= 2; ++o)
      for (std::size_t i = 0; i < up.of(o - 1).size(); ++i) {
        const Mp100 difference = (up.of(o - 1)[i] - down.of(o - 1)[i]) / (2 * step);
        EXPECT_LT(static_cast<double>(Mp100(abs(difference - found.of(o)[3 * i + a]))), 1e-50);
      }
  }
}

// Points on faces, edges and at a vertex, next to one inside.
TEST(elastic_on_the_cage, are_continuous) {
  const CageCoordinates e = elastic_at_level(embedded_cage("cube"), 1, 0.3);
  for (const Vec& p : {Vec(0.5, 0.125, 0.3125), Vec(0.5, 0.25, 0.25), Vec(0.5, 0.5, 0.125), Vec(0.5, 0.5, 0.5)})
    EXPECT_LT(largest_difference(values_at(e, p), values_at(e, p - 1e-12 * p)), 1e-9) << p.transpose();
}

TEST(elastic_on_the_cage, have_derivatives_from_inside) {
  const CageCoordinates e = elastic_at_level(embedded_cage("cube"), 1, 0.3);
  const Vec point(0.5, 0.15625, 0.28125);
  const auto on = e.at<double>(point, 2)[0], inside = e.at<double>(Vec(point - Vec(1e-9, 0, 0)), 2)[0],
             outside = e.at<double>(Vec(point + Vec(1e-9, 0, 0)), 1)[0];
  for (int o = 1; o <= 2; ++o) EXPECT_LT(largest_difference(on.of(o), inside.of(o)), 1e-5) << o;
  EXPECT_GT(largest_difference(on.gradient, outside.gradient), 1e-2);
}

TEST(elastic_on_the_cage, have_the_limits_of_places) {
  for (const double unit : {1., 0.125}) {
    const CageCoordinates e =
        elastic_at_level(mapped(embedded_cage("l-block"), unit * Eigen::Matrix3d::Identity(), Vec(1, 2, 3)), 0, 0.3);
    for (int t = 0; t < static_cast<int>(e.elements().count()); t += 5) {
      const Touching on{t, {0.5, 0.1875, 0.3125, 0}};
      Vec p = Vec::Zero();
      for (int c = 0; c < 3; ++c) p += on.basis[c] * e.elements().corners(t)[c];
      const auto limits = e.limits_at<double>(std::span(&on, 1), 1)[0];
      const auto inside = e.at<double>(Vec(p - 1e-9 * unit * e.elements().normals()[t]), 1)[0];
      for (int o = 0; o <= 1; ++o) EXPECT_LT(largest_difference(limits.tensors[o], inside.of(o)), 1e-5 / unit) << t;
      const auto fifty = e.limits_at<Mp50>(std::span(&on, 1), 0)[0];
      for (std::size_t i = 0; i < inside.value.size(); ++i)
        EXPECT_NEAR(static_cast<double>(fifty.tensors[0][i]), limits.tensors[0][i], 1e-12);
    }
  }
}

// At the pieces' centroids the border is met to rounding, elsewhere to the scheme's error.
TEST(elastic_on_the_cage, are_the_hat_functions_where_the_equation_is_asked_to_hold) {
  const CageCoordinates e = elastic_at_level(embedded_cage("cube"), 1, 0.3);
  const double centroid = 1. / 6;
  double elsewhere = 0;
  for (int t = 0; t < 12; ++t)
    for (const double second : {centroid, 0.25, 0.03125}) {
      const Touching on{t, {1 - second - centroid, second, centroid, 0}};
      std::vector<double> found = e.limits_at<double>(std::span(&on, 1), 0)[0].tensors[0];
      for (int c = 0; c < 3; ++c)
        for (std::size_t i = 0; i < 3; ++i) found[9 * e.elements().vertices_of(t)[c] + 4 * i] -= on.basis[c];
      double off = 0;
      for (const double x : found) off = std::max(off, std::abs(x));
      if (second == centroid) EXPECT_LT(off, 1e-13) << t;
      elsewhere = std::max(elsewhere, off);
    }
  RecordProperty("elsewhere", testing::PrintToString(elsewhere));
  EXPECT_LT(elsewhere, 0.1);
  EXPECT_GT(elsewhere, 1e-6) << "a study of errors that has none";
}

TEST(elastic_at_many_points, are_those_of_each) {
  const CageCoordinates e = elastic_at_level(embedded_cage("cube"), 0, 0.3);
  std::vector<Vec> points;
  points.reserve(40);
  for (int i = 0; i < 40; ++i) points.emplace_back(-0.5 + 0.015625 * i, 0.25, 0.125);  // the first on the cage
  const auto together = e.at<double>(std::span<const Vec>(points), 2)[0];
  for (std::size_t p = 0; p < points.size(); ++p) {
    const auto alone = e.at<double>(points[p], 2)[0];
    for (int o = 0; o <= 2; ++o)
      for (std::size_t i = 0; i < alone.of(o).size(); ++i)
        EXPECT_NEAR(together.tensors[o][p * together.stride[o] + i], alone.of(o)[i],
                    1e-13 * (1 + std::abs(alone.of(o)[i])));
  }
}

std::string elastic_refusal(const Cage& cage, const std::vector<double>& parameters) {
  try {
    CageCoordinates(cage, coordinate_kind_named("elastic"), CoordinateOptions{.parameters = parameters});
  } catch (const InputError& e) {
    return e.what();
  }
  return "";
}

TEST(elastic_in_space, refuse_what_they_cannot_do) {
  const Cage cube = embedded_cage("cube");
  EXPECT_NE(elastic_refusal(cube, {4, 1, 0.3, 5}).find("36864 unknowns, more than 8192"), std::string::npos);
  EXPECT_NE(elastic_refusal(cube, {2, 1, 0.3, 1}).find("pieces"), std::string::npos);
  EXPECT_NE(elastic_refusal(cube, {4, 0, 0.3, 1}).find("collocation"), std::string::npos);
  EXPECT_NE(elastic_refusal(cube, {4, 1, 0.5, 1}).find("nu"), std::string::npos);
  EXPECT_NE(elastic_refusal(polygon(unit_square), {4, 1, 0.3, 2}).find("level"), std::string::npos);
  EXPECT_EQ(elastic_refusal(cube, {4, 1, 0.3, 0}), "");
  EXPECT_NE(elastic_refusal(embedded_cage("thin-box"), {4, 1, 0.3, 0}).find("a wall is too thin"), std::string::npos);
  // Two cubes that share a corner's surroundings: there Somigliana's matrices sum to twice the identity.
  std::vector<Vec> vertices = cube.vertices();
  std::vector<Face> faces = cube.faces();
  for (const Vec& v : cube.vertices()) vertices.push_back(v + Vec(0.5, 0.4375, 0.375));
  for (Face f : cube.faces()) {
    for (int k = 0; k < f.size(); ++k) f.vertices[k] += 8;
    faces.push_back(f);
  }
  EXPECT_NE(elastic_refusal(Cage::make("two", vertices, faces), {4, 1, 0.3, 1}).find("overlaps itself"),
            std::string::npos);
  for (Vec& v : vertices) v *= 0x1p1023;
  EXPECT_NE(elastic_refusal(Cage::make("vast", vertices, faces), {4, 1, 0.3, 1}).find("range of double"),
            std::string::npos);
}

}  // namespace
}  // namespace cageproof::solved::test::elastic_in_space_laws_test
