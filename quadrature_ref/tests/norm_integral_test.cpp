// SPDX-License-Identifier: MIT
// The integral of a kernel's norm, where it is known without integrating.
#include "cageproof/quadrature_ref/norm_integral.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

namespace cageproof::quadrature_ref {
namespace {

const std::array<Vec3<double>, 3> kRight{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}}};

TEST(NormIntegral, of_a_kernel_of_one_sign_is_the_size_of_its_integral) {
  // An eighth of a cube's side, seen from the cube's middle.
  for (const double height : {1.0, -1.0}) {
    const double found =
        norm_integral(formula_named("triangle.solid_angle"), {.corners = kRight, .point = {0, 0, height}});
    EXPECT_NEAR(found, std::numbers::pi / 12, 1e-6) << height;
  }
}

TEST(NormIntegral, has_the_peak_next_to_the_element) {
  for (const double height : {1e-3, 1e-9, 1e-15}) {
    const double found =
        norm_integral(formula_named("triangle.solid_angle"), {.corners = kRight, .point = {0.5, 0.25, height}});
    EXPECT_NEAR(found, 2 * std::numbers::pi, 0.1) << height;
  }
}

TEST(NormIntegral, is_not_zero_where_the_integral_is) {
  // ln r changes its sign on the segment.
  const std::array<Vec3<double>, 2> segment{{{0.5, 0, 0}, {2, 0, 0}}};
  const double found = norm_integral(formula_named("segment.single_layer"), {.corners = segment});
  EXPECT_NEAR(found, ((0.5 * std::log(0.5) + 0.5) + (2 * std::log(2) - 1)) / (2 * std::numbers::pi), 1e-3);
}

TEST(NormIntegral, takes_quads) {
  const std::array<Vec3<double>, 4> square{{{-1, -1, 1}, {1, -1, 1}, {1, 1, 1}, {-1, 1, 1}}};
  EXPECT_NEAR(norm_integral(formula_named("quad.solid_angle"), {.corners = square}), 2 * std::numbers::pi / 3, 1e-6);
}

}  // namespace
}  // namespace cageproof::quadrature_ref
