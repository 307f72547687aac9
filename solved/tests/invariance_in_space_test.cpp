// SPDX-License-Identifier: MIT
// Harmonic coordinates in space depend only on the cage's shape, in every scalar, and so do their derivatives.
#include "cageproof/core/cage/embedded_cages.h"
#include "space_support.h"

#include <gtest/gtest.h>

namespace cageproof::solved::test::invariance_in_space_test {
namespace {

// A block of triangles, because a quad's diagonal may change when the cage turns.
Cage block() { return split_cage(embedded_cage("l-block"), 0); }

Cage moved(const Cage& cage, const Eigen::Matrix3d& map, const Vec& offset) {
  std::vector<Vec> vertices;
  for (const Vec& v : cage.vertices()) vertices.push_back(map * v + offset);
  std::vector<Face> faces = cage.faces();
  if (map.determinant() < 0)
    for (Face& f : faces) std::swap(f.vertices[1], f.vertices[2]);
  return Cage::make("moved", vertices, faces);
}

void expect_same(const Eigen::Matrix3d& map, const Vec& offset, double tolerance) {
  const CageCoordinates h = harmonic_at_level(block(), 0), other = harmonic_at_level(moved(block(), map, offset), 0);
  for (const Vec& p : inner_points(h.elements(), 3))
    EXPECT_LT(largest_difference(values_at(h, p), values_at(other, map * p + offset)), tolerance);
}

TEST(harmonic_of_moved_cages, are_the_same) {
  const Eigen::Matrix3d one = Eigen::Matrix3d::Identity();
  const Eigen::Matrix3d turn =
      (Eigen::AngleAxisd(0.7, Vec(1, 2, -1).normalized()) * Eigen::AngleAxisd(1.1, Vec(0, 1, 3).normalized()))
          .toRotationMatrix();
  expect_same(one, Vec(64, -32, 16), 1e-13);
  expect_same(one, Vec(1e6, -3e6, 2e6), 1e-8);  // where cage and points are rounded to 5e-10
  expect_same(turn, Vec::Zero(), 1e-13);
  expect_same(Eigen::Vector3d(-1, 1, 1).asDiagonal(), Vec::Zero(), 1e-13);
  expect_same(turn * Eigen::Vector3d(1, 1, -1).asDiagonal(), Vec(1, 2, 3), 1e-12);
}

TEST(harmonic_of_moved_cages, have_no_unit_of_length) {
  for (const double unit : {1e-90, 1e-6, 3., 1e6, 1e90})
    expect_same(unit * Eigen::Matrix3d::Identity(), Vec::Zero(), 1e-13);
}

TEST(harmonic_of_moved_cages, have_gradients_over_the_unit) {
  const CageCoordinates h = harmonic_at_level(block(), 0),
                        large = harmonic_at_level(moved(block(), 8 * Eigen::Matrix3d::Identity(), Vec::Zero()), 0);
  const Vec p = inner_points(h.elements(), 3)[0];
  const auto small_one = h.at<double>(p, 2)[0], large_one = large.at<double>(Vec(8 * p), 2)[0];
  for (std::size_t i = 0; i < small_one.gradient.size(); ++i)
    EXPECT_EQ(small_one.gradient[i], 8 * large_one.gradient[i]);
  for (std::size_t i = 0; i < small_one.hessian.size(); ++i) EXPECT_EQ(small_one.hessian[i], 64 * large_one.hessian[i]);
}

TEST(harmonic_in_every_scalar, have_its_digits) {
  const CageCoordinates h = harmonic_at_level(embedded_cage("cube"), 0);
  for (const Vec& p : {Vec(0.1, 0.2, 0.3), Vec(0.5, 0.25, -0.125), Vec(0.5, 0.5, 0.5)}) {
    const auto fifty = h.at<Mp50>(convert<Mp50>(p), 0)[0].value;
    const auto twice = h.at<double>(p, 0)[0].value;
    const auto single = h.at<float>(convert<float>(p), 0)[0].value;
    for (std::size_t i = 0; i < fifty.size(); ++i) {
      EXPECT_NEAR(twice[i], static_cast<double>(fifty[i]), 1e-13);
      EXPECT_NEAR(single[i], twice[i], 1e-6);
    }
  }
  EXPECT_TRUE(h.is_exact_in(ScalarKind::Digits50));
  EXPECT_FALSE(h.is_exact_in(ScalarKind::Digits100));
}

TEST(harmonic_in_every_scalar, have_the_derivatives_of_their_values) {
  const CageCoordinates h = harmonic_at_level(embedded_cage("cube"), 0);
  const Mp100 step("1e-30");
  const Vec3<Mp100> point(Mp100("0.14"), Mp100("-0.22"), Mp100("0.31"));
  const auto found = h.at<Mp100>(point, 2)[0];
  for (int a = 0; a < 3; ++a) {
    Vec3<Mp100> plus = point, minus = point;
    plus[a] += step;
    minus[a] -= step;
    const auto up = h.at<Mp100>(plus, 1)[0], down = h.at<Mp100>(minus, 1)[0];
    for (int o = 1; o <= 2; ++o)
      for (std::size_t i = 0; i < up.of(o - 1).size(); ++i) {
        const Mp100 difference = (up.of(o - 1)[i] - down.of(o - 1)[i]) / (2 * step);
        EXPECT_LT(static_cast<double>(Mp100(abs(difference - found.of(o)[3 * i + a]))), 1e-50);
      }
  }
}

// Points on faces, edges and at a vertex, next to one inside.
TEST(harmonic_on_the_cage, are_continuous) {
  const CageCoordinates h = harmonic_at_level(embedded_cage("cube"), 1);
  const double step = 1e-12;
  for (const Vec& p : {Vec(0.5, 0.125, 0.3125), Vec(0.5, 0.25, 0.25), Vec(0.5, 0.5, 0.125), Vec(0.5, 0.5, 0.5)})
    EXPECT_LT(largest_difference(values_at(h, p), values_at(h, p - step * p)), 1e-10) << p.transpose();
}

TEST(harmonic_on_the_cage, have_derivatives_from_inside) {
  const CageCoordinates h = harmonic_at_level(embedded_cage("cube"), 1);
  const Vec point(0.5, 0.15625, 0.28125);
  const auto on = h.at<double>(point, 2)[0], inside = h.at<double>(Vec(point - Vec(1e-9, 0, 0)), 2)[0],
             outside = h.at<double>(Vec(point + Vec(1e-9, 0, 0)), 1)[0];
  for (int o = 1; o <= 2; ++o) EXPECT_LT(largest_difference(on.of(o), inside.of(o)), 1e-5) << o;
  EXPECT_GT(largest_difference(on.gradient, outside.gradient), 1e-2);
}

TEST(harmonic_on_the_cage, have_the_limits_of_places) {
  const CageCoordinates h = harmonic_at_level(embedded_cage("cube"), 0);
  for (int e = 0; e < static_cast<int>(h.elements().count()); ++e) {
    const Touching on{e, {0.5, 0.1875, 0.3125, 0}};
    Vec p = Vec::Zero();
    for (int c = 0; c < 3; ++c) p += on.basis[c] * h.elements().corners(e)[c];
    const auto limits = h.limits_at<double>(std::span(&on, 1), 1)[0];
    const auto inside = h.at<double>(Vec(p - 1e-9 * h.elements().normals()[e]), 1)[0];
    for (int o = 0; o <= 1; ++o) EXPECT_LT(largest_difference(limits.tensors[o], inside.of(o)), 1e-5) << e;
    const auto fifty = h.limits_at<Mp50>(std::span(&on, 1), 0)[0];
    for (std::size_t i = 0; i < inside.value.size(); ++i)
      EXPECT_NEAR(static_cast<double>(fifty.tensors[0][i]), limits.tensors[0][i], 1e-12);
  }
}

TEST(harmonic_at_many_points, are_those_of_each) {
  const CageCoordinates h = harmonic_at_level(embedded_cage("cube"), 0);
  std::vector<Vec> points;
  points.reserve(70);
  for (int i = 0; i < 70; ++i) points.emplace_back(-0.5 + 0.0078125 * i, 0.25, 0.125);  // the first on the cage
  const auto together = h.at<double>(std::span<const Vec>(points), 2)[0];
  for (std::size_t p = 0; p < points.size(); ++p) {
    const auto alone = h.at<double>(points[p], 2)[0];
    for (int o = 0; o <= 2; ++o)
      for (std::size_t i = 0; i < alone.of(o).size(); ++i)
        EXPECT_NEAR(together.tensors[o][p * together.stride[o] + i], alone.of(o)[i],
                    1e-13 * (1 + std::abs(alone.of(o)[i])));
  }
}

}  // namespace
}  // namespace cageproof::solved::test::invariance_in_space_test
