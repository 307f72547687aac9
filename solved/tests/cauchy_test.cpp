// SPDX-License-Identifier: MIT
// Cauchy coordinates against Cauchy's integral, and as what they are: Green coordinates in complex numbers.
#include "support.h"

#include "cageproof/core/coordinates/whole_evaluation.h"

#include <gtest/gtest.h>

namespace cageproof::solved::test {
namespace {

using C = std::complex<double>;

C complex(const Vec& p) { return {p[0], p[1]}; }

std::vector<C> cauchy(const CageCoordinates& c, const Vec& point) {
  const auto found = c.at<double>(point, 0);
  std::vector<C> all;
  for (std::size_t j = 0; j < found[0].value.size(); ++j) all.emplace_back(found[0].value[j], found[1].value[j]);
  return all;
}

// 1/(2 pi i) times the integral of a vertex's hat function over (w - z), edge by edge, by Simpson's rule on 4096 parts.
std::vector<C> by_definition(const Cage& cage, const Vec& point) {
  std::vector<C> sums(cage.vertices().size());
  const C z = complex(point), factor(0, -0.5 / 3.14159265358979323846);
  constexpr int parts = 4096;
  for (const Face& face : cage.faces()) {
    const C a = complex(cage.vertices()[face.vertices[0]]), b = complex(cage.vertices()[face.vertices[1]]);
    for (int k = 0; k <= parts; ++k) {
      const double t = static_cast<double>(k) / parts;
      const double weight = (k == 0 || k == parts ? 1 : k % 2 == 1 ? 4 : 2) / (3. * parts);
      const C term = factor * weight * (b - a) / (a + t * (b - a) - z);
      sums[face.vertices[0]] += (1 - t) * term;
      sums[face.vertices[1]] += t * term;
    }
  }
  return sums;
}

TEST(cauchy, are_cauchys_integrals_of_hat_functions) {
  for (const Cage& cage : {polygon(unit_square), polygon(convex_pentagon), polygon(l_shape)})
    for (const Vec& point : {Vec(0.5, 0.5, 0), Vec(0.25, 0.75, 0), Vec(0.5, 0.3, 0)}) {
      const auto found = cauchy(coordinates(cage, "cauchy"), point), truth = by_definition(cage, point);
      for (std::size_t j = 0; j < truth.size(); ++j) EXPECT_LT(std::abs(found[j] - truth[j]), 1e-12);
    }
}

TEST(cauchy, reproduce_every_similarity_everywhere) {
  const C turn(0.6, -1.3), move(2, -0.7);
  for (const Cage& cage : {polygon(unit_square), polygon(convex_pentagon), polygon(l_shape), polygon(thin_bar), ring()})
    for (const Vec& point :
         {Vec(0.5, 0.0078125, 0), Vec(0.5, 0, 0), Vec(0, 0, 0), Vec(1e-12, 0.01, 0), Vec(0.25, 0.0078125, 0)}) {
      C sum = 0;
      const auto found = cauchy(coordinates(cage, "cauchy"), point);
      for (std::size_t j = 0; j < found.size(); ++j) sum += found[j] * (turn * complex(cage.vertices()[j]) + move);
      EXPECT_LT(std::abs(sum - (turn * complex(point) + move)), 1e-14) << point.transpose();
    }
}

// [W12] Section 5.2: vertices go to f_j, normals to the turned edges' over their lengths.
TEST(cauchy, deform_as_green_coordinates_do) {
  const Cage cage = polygon(l_shape);
  const std::vector<C> posed{{0.1, 0}, {2.2, -0.4}, {1.7, 1.2}, {1, 1.3}, {0.7, 2.5}, {-0.3, 1.8}};
  const CageCoordinates green(cage, coordinate_kind_named("green"), CoordinateOptions{}),
      c = coordinates(cage, "cauchy");
  for (const Vec& point : {Vec(0.5, 0.5, 0), Vec(1.75, 0.001, 0), Vec(1, 1.5, 0), Vec(1, 1, 0), Vec(0, 0.375, 0)}) {
    const auto blocks = green.at<double>(point, 0);
    C expected = 0;
    for (std::size_t j = 0; j < 6; ++j) {
      const double length = (cage.vertices()[(j + 1) % 6] - cage.vertices()[j]).norm();
      expected +=
          blocks[0].value[j] * posed[j] - C(0, 1) * blocks[1].value[j] * (posed[(j + 1) % 6] - posed[j]) / length;
    }
    C sum = 0;
    const auto found = cauchy(c, point);
    for (std::size_t j = 0; j < 6; ++j) sum += found[j] * posed[j];
    EXPECT_LT(std::abs(sum - expected), 1e-14) << point.transpose();
  }
}

TEST(cauchy, are_holomorphic) {
  const auto found = coordinates(polygon(convex_pentagon), "cauchy").at<double>(Vec(0.7, 0.9, 0), 2);
  for (std::size_t j = 0; j < 5; ++j) {
    const double* re = &found[0].gradient[2 * j];
    const double* im = &found[1].gradient[2 * j];
    EXPECT_NEAR(re[0], im[1], 1e-14);
    EXPECT_NEAR(re[1], -im[0], 1e-14);
    EXPECT_NEAR(found[0].hessian[4 * j], found[1].hessian[4 * j + 1], 1e-14);
  }
}

// Kelvin's tractions without their logarithm, against the layers of Green coordinates in 50 digits. Next to a vertex
// derivatives of its two edges' layers are 1e9 times what is left of them.
TEST(cauchy, are_right_at_many_points_at_once) {
  const double short_edge = 1e-6;
  const Cage bevel = polygon({{0, 0}, {1, 0}, {1, 1 - short_edge}, {1 - short_edge, 1}, {0, 1}});
  for (const Cage& cage : {polygon(convex_pentagon), polygon(l_shape), bevel}) {
    std::vector<Vec> points{Vec(0.3, 0.4, 0), Vec(0.7, 0.9, 0), Vec(0.999, 0.998, 0), Vec(-0.5, 2.5, 0),
                            Vec(40, 30, 0)};
    for (const Vec& v : cage.vertices())
      for (const double from : {1e-3, 1e-9}) points.emplace_back(v + from * Vec(0.3, 0.9, 0));
    const CageCoordinates many(cage, coordinate_kind_named("cauchy"),
                               CoordinateOptions{.evaluation = std::string(quickest)});
    EXPECT_EQ(many.evaluation(), "batched");
    const CageCoordinates layers(cage, coordinate_kind_named("cauchy"), CoordinateOptions{});
    std::vector<Vec3<Mp50>> exactly;
    exactly.reserve(points.size());
    for (const Vec& p : points) exactly.push_back(convert<Mp50>(p));
    const auto found = many.at<double>(std::span<const Vec>(points), 2);
    const auto truth = layers.at<Mp50>(std::span<const Vec3<Mp50>>(exactly), 2);
    for (int o = 0; o <= 2; ++o)
      for (std::size_t p = 0; p < points.size(); ++p) {
        const std::size_t width = found[0].stride[o];
        Mp50 largest = 0, error = 0;
        for (std::size_t block = 0; block < 2; ++block)
          for (std::size_t i = 0; i < width; ++i) {
            const Mp50 is = truth[block].tensors[o][p * width + i];
            largest = std::max(largest, Mp50(abs(is)));
            error = std::max(error, Mp50(abs(found[block].tensors[o][p * width + i] - is)));
          }
        EXPECT_LT(static_cast<double>(error / largest), 64 * 0x1p-53)
            << cage.name() << " order " << o << " at " << points[p].transpose();
      }
  }
}

}  // namespace
}  // namespace cageproof::solved::test
