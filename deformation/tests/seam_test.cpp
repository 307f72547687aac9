// SPDX-License-Identifier: MIT
// [W12] Figure 10: a square is cut along a diagonal, each half is posed by itself, and the halves are put together.
#include "support.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace cageproof::deformation::test {
namespace {

constexpr double kStretch = 0.8;  // of the seam's normal derivative, the same on both sides

// A half, its pose and its normal derivatives: those of the seam are of one vector, outward on either side.
struct Half {
  Case half;
  std::vector<Vec> normal_derivatives;
};

// The corner off the seam is (1,0) or (0,1); the vertex (1,1) is drawn in, so that the square becomes an L.
Half half(bool lower) {
  const double s = std::sqrt(0.5), in = -0.55;
  const Vec across = kStretch * Vec(-s, s, 0);
  if (lower)
    return {polygon("lower", {{0, 0}, {1, 0}, {1, 1}}, {{0, 0}, {0, 0}, {in, in}}, {}),
            {Vec(0, -1, 0), Vec(0.633, -0.774, 0), across}};
  return {polygon("upper", {{0, 0}, {1, 1}, {0, 1}}, {{0, 0}, {in, in}, {0, 0}}, {}),
          {-across, Vec(-0.774, 0.633, 0), Vec(-1, 0, 0)}};
}

Vec beside_seam(double along, double depth, bool lower) {
  const double off = (lower ? depth : -depth) * std::sqrt(0.5);
  return {along + off, along - off, 0};
}

// The largest difference of Jacobians at that depth on the two sides, at three places of the seam.
double largest_jump(double depth, const auto& jacobian) {
  double largest = 0;
  for (const double along : {0.3, 0.5, 0.7})
    largest = std::max(largest, (jacobian(half(true), beside_seam(along, depth, true)) -
                                 jacobian(half(false), beside_seam(along, depth, false)))
                                    .norm());
  return largest;
}

using Jacobian = Eigen::Matrix2d;

Jacobian jacobian_of(const Images<double>& images) {
  const auto& t = images.tensors[1];
  return Jacobian{{t[0], t[1]}, {t[2], t[3]}};
}

// By coordinates of values and normal derivatives, however they are computed.
Jacobian with_coordinates(const char* kind, const Half& of, const Vec& point) {
  const CageCoordinates coordinates(of.half.cage, coordinate_kind_named(kind), CoordinateOptions{});
  const auto blocks = coordinates.at<double>(point, 1);
  Jacobian found = Jacobian::Zero();
  const auto add = [&](const std::vector<double>& gradients, const std::vector<Vec>& data) {
    for (std::size_t i = 0; i < data.size(); ++i)
      for (int c = 0; c < 2; ++c)
        for (int a = 0; a < 2; ++a) found(c, a) += gradients[2 * i + a] * data[i][c];
  };
  add(blocks[0].gradient, of.half.posed);
  if (blocks.size() > 1) add(blocks[1].gradient, of.normal_derivatives);
  return found;
}

TEST(seam, is_smooth_with_biharmonic_coordinates_and_has_a_kink_with_harmonic_ones) {
  const auto harmonic = [](const Half& of, const Vec& point) {
    return jacobian_of(deformed(*prepared(of.half.cage, "harmonic"), of.half.posed, {point}, 1));
  };
  const auto biharmonic = [](const Half& of, const Vec& point) {
    return with_coordinates("biharmonic_goursat", of, point);
  };
  EXPECT_GT(largest_jump(1e-3, harmonic), 1);
  EXPECT_GT(largest_jump(1e-4, harmonic), 1);
  // Second derivatives times the distance between the two points, which is a tenth.
  const double near = largest_jump(1e-4, biharmonic);
  EXPECT_LT(near, 5e-3);
  EXPECT_NEAR(largest_jump(1e-3, biharmonic) / near, 10, 0.5);
}

// The paper's scheme meets normal derivatives roughly; the kink is less than the harmonic one.
TEST(seam, kink_is_less_with_solved_coordinates) {
  const auto jump = [&](double pieces) {
    return largest_jump(1e-3, [&](const Half& of, const Vec& point) {
      const auto deformer = prepared(of.half.cage, "biharmonic_boundary", {0, pieces, 1, 0});
      const auto pose = deformer->pose({of.half.posed, of.normal_derivatives});
      return jacobian_of(deformer->images(*pose, std::span(&point, 1), 1));
    });
  };
  EXPECT_LT(jump(4), 0.8);
  EXPECT_LT(jump(32), jump(8));
}

}  // namespace
}  // namespace cageproof::deformation::test
