// SPDX-License-Identifier: MIT
// Quad, spherical and maximum entropy coordinates against their definitions, by ways of their own.
#include "coordinates/maximum_entropy.h"
#include "cageproof/core/coordinates/coordinates.h"
#include "cageproof/core/cage/embedded_cages.h"
#include "cageproof/core/numbers/gauss_legendre.h"
#include "cageproof/core/input_error.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

namespace cageproof::adaptive_qmvc::coordinate_kinds_test {
namespace {

using Vec = Vec3<double>;

std::vector<double> at(const Cage& cage, const char* kind, const Vec& point) {
  return CageCoordinates(cage, *find_coordinate_kind(kind), CoordinateOptions{}).at<double>(point, 0)[0].value;
}

double largest_difference(const std::vector<double>& a, const std::vector<double>& b) {
  double worst = a.size() == b.size() ? 0 : HUGE_VAL;
  for (std::size_t i = 0; i < a.size(); ++i) worst = std::max(worst, std::abs(a[i] - b[i]));
  return worst;
}

// [T18] Eq 11 by a product rule, fine for points far from the cage, quads and triangles alike (a triangle is a quad
// with two equal corners).
std::vector<double> integrated(const Cage& cage, const Vec& eta) {
  const auto rule = gauss_legendre<double>(60);
  std::vector<double> w(cage.vertices().size(), 0.0);
  for (const Face& face : cage.faces()) {
    std::array<int, 4> v = face.vertices;
    if (face.size() == 3) v[3] = v[2];
    std::array<Vec, 4> q;
    for (int k = 0; k < 4; ++k) q[k] = cage.vertices()[v[k]];
    for (std::size_t i = 0; i < rule.nodes.size(); ++i)
      for (std::size_t j = 0; j < rule.nodes.size(); ++j) {
        const double u = rule.nodes[i], t = rule.nodes[j];
        const std::array<double, 4> basis{(1 - u) * (1 - t), u * (1 - t), u * t, (1 - u) * t};
        const Vec x = basis[0] * q[0] + basis[1] * q[1] + basis[2] * q[2] + basis[3] * q[3] - eta;
        const Vec n =
            Vec((1 - t) * (q[1] - q[0]) + t * (q[2] - q[3])).cross(Vec((1 - u) * (q[3] - q[0]) + u * (q[2] - q[1])));
        const double weight = rule.weights[i] * rule.weights[j] * n.dot(x) / (x.squaredNorm() * x.squaredNorm());
        for (int k = 0; k < 4; ++k) w[v[k]] += basis[k] * weight;
      }
  }
  const double sum = std::accumulate(w.begin(), w.end(), 0.0);
  for (double& x : w) x /= sum;
  return w;
}

TEST(quad_mean_value, is_its_integral) {
  for (const auto& [name, point] : {std::pair{"cube", Vec(0.11, -0.07, 0.05)},
                                    {"twisted-bar", Vec(0.1, 0.05, 0.2)},
                                    {"spiky-box", Vec(0.03, 0.1, 0.02)},
                                    {"l-block", Vec(-0.4, -0.45, 0.03)}}) {
    const Cage cage = embedded_cage(name);
    EXPECT_LE(largest_difference(at(cage, "quad_mean_value", point), integrated(cage, point)), 1e-10) << name;
  }
}

TEST(quad_mean_value, is_bilinear_on_quads) {
  constexpr std::array kBasis{9 / 16.0, 3 / 16.0, 1 / 16.0, 3 / 16.0};
  int asked = 0;
  for (const char* name : {"cube", "twisted-bar", "torus", "spiky-box"}) {
    const Cage cage = embedded_cage(name);
    const CageCoordinates lambda(cage, *find_coordinate_kind("quad_mean_value"), CoordinateOptions{});
    for (std::size_t f = 0; f < cage.faces().size(); ++f) {
      if (cage.faces()[f].size() != 4) continue;
      const auto q = cage.quad(f);
      const Vec point = (9 * q[0] + 3 * q[1] + q[2] + 3 * q[3]) / 16;
      if (lambda.elements().touching(point).empty()) continue;  // rounding moved it off the quad
      const auto found = lambda.at<double>(point, 0)[0].value;
      for (int k = 0; k < 4; ++k) EXPECT_NEAR(found[cage.faces()[f].vertices[k]], kBasis[k], 1e-15) << name << ' ' << f;
      ++asked;
    }
  }
  EXPECT_GE(asked, 10);
}

TEST(quad_mean_value, names_invalid_quads) {
  std::vector<Vec> vertices;
  for (const double z : {0.0, 1.0})
    for (const auto& [x, y] : {std::pair{0.0, 0.0}, {2.0, -1.0}, {1.0, 0.0}, {2.0, 1.0}})
      vertices.emplace_back(x, y, z);
  const std::vector<Face> faces{{{0, 3, 2, 1}}, {{4, 5, 6, 7}}, {{0, 1, 5, 4}},
                                {{1, 2, 6, 5}}, {{2, 3, 7, 6}}, {{3, 0, 4, 7}}};
  const Vec inside(0.5, 0.01, 0.4);
  const Cage strict = Cage::make("arrowheads", vertices, faces);
  EXPECT_NO_THROW(at(strict, "mean_value", inside));
  try {
    at(strict, "quad_mean_value", inside);
    ADD_FAILURE() << "an invalid quad was taken";
  } catch (const InputError& e) {
    const std::string what = e.what();
    for (const char* part : {"arrowheads", "face 0", "folds over", "1 more", "--allow-invalid-quads"})
      EXPECT_NE(what.find(part), std::string::npos) << what;
  }
  const Cage loose = Cage::make("arrowheads", vertices, faces, {.allow_invalid_quads = true});
  EXPECT_LE(largest_difference(at(loose, "quad_mean_value", inside), integrated(loose, inside)), 1e-4);
}

// The weights are those of triangles on a cage of triangles.
TEST(spherical, agrees_with_mean_value_on_triangles) {
  const Cage cage = embedded_cage("icosphere");
  const Vec point(0.3, -0.2, 0.1);
  EXPECT_LE(largest_difference(at(cage, "spherical_mean_value", point), at(cage, "mean_value", point)), 1e-14);
}

TEST(spherical, keeps_the_cube_symmetric_and_reproduces) {
  const Cage cube = embedded_cage("cube");
  for (const double x : at(cube, "spherical_mean_value", Vec(0, 0, 0))) EXPECT_NEAR(x, 1.0 / 8, 1e-15);
  for (const Vec& point : {Vec(0.1, 0.2, 0.3), Vec(0.49, 0.1, 0), Vec(0.7, 0.1, 0.2)}) {
    const auto found = at(cube, "spherical_mean_value", point);
    Vec sum = Vec::Zero();
    for (std::size_t i = 0; i < found.size(); ++i) sum += found[i] * cube.vertices()[i];
    EXPECT_LE((sum - point).norm(), 1e-14);
  }
  // Within a face: mean value coordinates of the square, which are not bilinear.
  const Vec on(0.5, 0.25, 0.125), off(0.5 - 1e-10, 0.25, 0.125);
  EXPECT_LE(largest_difference(at(cube, "spherical_mean_value", on), at(cube, "spherical_mean_value", off)), 1e-8);
  EXPECT_GE(largest_difference(at(cube, "spherical_mean_value", on), at(cube, "quad_mean_value", on)), 1e-3);
}

// Outside a thin wall the weights of its sides, and their sum, cancel.
TEST(spherical, reproduces_outside_thin_walls) {
  std::vector<Face> faces;
  for (const std::array<int, 4>& f : {std::array{0, 2, 4, -1},
                                      {2, 1, 4, -1},
                                      {1, 3, 4, -1},
                                      {3, 0, 4, -1},
                                      {2, 0, 5, -1},
                                      {1, 2, 5, -1},
                                      {3, 1, 5, -1},
                                      {0, 3, 5, -1}})
    faces.push_back({f});
  for (const double height : {1e-2, 1e-4, 1e-6}) {
    const Cage cage = Cage::make(
        "flat octahedron", {{1, 0, 0}, {-1, 0, 0}, {0, height, 0}, {0, -height, 0}, {0, 0, 1}, {0, 0, -1}}, faces, {});
    for (const Vec& point : {Vec(0.164, 0.286, 0.491), Vec(-0.142, 0.285, 0.366), Vec(-0.085, -0.0286, -0.408),
                             Vec(0.3, -4, 0.2), Vec(1.5, 0.1, -0.25)})
      for (const int order : {0, 1}) {
        const auto found = CageCoordinates(cage, *find_coordinate_kind("spherical_mean_value"), CoordinateOptions{})
                               .at<double>(point, order)[0]
                               .value;
        Vec sum = -point;
        double size = 0;
        for (std::size_t i = 0; i < found.size(); ++i) {
          sum += found[i] * cage.vertices()[i];
          size += std::abs(found[i]) * cage.vertices()[i].norm();
        }
        EXPECT_LE(sum.norm(), 64 * 0x1p-53 * size) << height << ", " << point.transpose();
      }
  }
}

// With a prior of no derivatives.
std::vector<double> entropy_at(const Cage& cage, std::vector<double> prior, const Vec& point) {
  Result<double> m, found;
  m.value = std::move(prior);
  maximum_entropy(cage.vertices(), m, point, cage.size(), 0, found);
  return found.value;
}

TEST(spherical, names_the_evaluation_that_it_does_not_have) {
  const Cage cube = embedded_cage("cube");
  const CoordinateKind& kind = coordinate_kind_named("spherical_mean_value");
  EXPECT_NO_THROW(CageCoordinates(cube, kind, CoordinateOptions{.evaluation = "hybrid"}));
  try {
    const CageCoordinates refused(cube, kind, CoordinateOptions{.evaluation = "line-12"});
    ADD_FAILURE() << "an evaluation that does not exist was accepted";
  } catch (const InputError& e) {
    EXPECT_STREQ(e.what(), "spherical_mean_value has no evaluation 'line-12', only hybrid");
  }
}

TEST(coordinate_kinds, refuse_evaluations_that_there_are_not) {
  const Cage cube = embedded_cage("cube");
  for (const char* name : {"mean_value", "quad_mean_value", "green"})
    EXPECT_THROW(CageCoordinates(cube, coordinate_kind_named(name), CoordinateOptions{.evaluation = "no-such"}),
                 InputError)
        << name;
}

TEST(coordinate_kinds, have_the_bits_of_single_points_in_blocks) {
  const Cage cube = embedded_cage("cube");
  const std::vector<Vec> points{Vec(.1, .2, -.3), Vec(-.2, .3, .15), Vec(.3, -.1, .2), Vec(.05, -.25, -.4)};
  for (const char* name : {"mean_value", "quad_mean_value"}) {
    const CageCoordinates kind(cube, coordinate_kind_named(name), CoordinateOptions{});
    const auto block = kind.at<double>(std::span<const Vec>(points), 2);
    for (std::size_t p = 0; p < points.size(); ++p) {
      const Result<double> one = kind.at<double>(points[p], 2)[0];
      for (int o = 0; o <= 2; ++o)
        for (std::size_t i = 0; i < one.of(o).size(); ++i)
          EXPECT_EQ(block[0].tensors[o][p * block[0].stride[o] + i], one.of(o)[i]) << name << ' ' << o;
    }
  }
}

TEST(maximum_entropy, keeps_a_prior_that_reproduces) {
  const Cage cube = embedded_cage("cube");
  const Vec point(0.1, 0.2, -0.3);
  EXPECT_LE(largest_difference(at(cube, "maximum_entropy", point), at(cube, "quad_mean_value", point)), 1e-14);
}

// A uniform prior on a cube: the product of three problems in one dimension, each solved by hand: (1 +- 2x)/2.
TEST(maximum_entropy, factors_on_a_cube) {
  const Cage cube = embedded_cage("cube");
  const std::vector<double> prior(8, 3.0);
  for (const Vec& point : {Vec(0.1, 0.2, -0.3), Vec(0.4999, 0, 0.3), Vec(0.49, 0.49, 0.49)}) {
    const auto found = entropy_at(cube, prior, point);
    for (int i = 0; i < 8; ++i) {
      double expected = 1;
      for (int c = 0; c < 3; ++c) expected *= 0.5 + 2 * cube.vertices()[i][c] * point[c];
      EXPECT_NEAR(found[i], expected, 1e-12);
    }
  }
}

TEST(maximum_entropy, is_positive_where_the_prior_is_not) {
  const Cage cage = embedded_cage("l-block");
  const Vec point(-0.9, 0.95, 0.4);
  const auto prior = at(cage, "quad_mean_value", point), found = at(cage, "maximum_entropy", point);
  EXPECT_LT(*std::ranges::min_element(prior), -1e-6);
  EXPECT_GE(*std::ranges::min_element(found), 0);
  Vec sum = Vec::Zero();
  for (std::size_t i = 0; i < found.size(); ++i) sum += found[i] * cage.vertices()[i];
  EXPECT_LE((sum - point).norm(), 1e-13);
}

TEST(maximum_entropy, has_none_outside_the_hull) {
  const Cage cube = embedded_cage("cube");
  for (const Vec& point : {Vec(0.6, 0, 0), Vec(0.5000001, 0, 0), Vec(3, 4, 5)})
    EXPECT_TRUE(std::isnan(entropy_at(cube, std::vector<double>(8, 1.0), point)[0]));
}

}  // namespace
}  // namespace cageproof::adaptive_qmvc::coordinate_kinds_test
