// SPDX-License-Identifier: MIT
#include "cageproof/closed_form/triangle/affine_single_layer.h"
#include "cageproof/closed_form/triangle/biharmonic_double_layer.h"
#include "cageproof/closed_form/triangle/biharmonic_single_layer.h"
#include "cageproof/closed_form/triangle/double_layer.h"
#include "cageproof/closed_form/triangle/engine/closed_form.h"
#include "cageproof/closed_form/triangle/kelvin_displacement.h"
#include "cageproof/closed_form/triangle/kelvin_traction.h"
#include "cageproof/closed_form/triangle/mean_value.h"
#include "cageproof/closed_form/triangle/single_layer.h"
#include "cageproof/closed_form/triangle/solid_angle.h"
#include "cageproof/core/numbers/random_stream.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace cageproof::closed_form::triangle::potentials_test {
namespace {

using Vec = Vec3<double>;

template <class F, Scalar R = double>
Jet<R, F::components> evaluate(const Triangle<R>& t, const Vec3<R>& p, int order, std::span<const R> parameters = {}) {
  if (order == 0) return closed_form<F, 0, R>(t, p, parameters);
  if (order == 1) return closed_form<F, 1, R>(t, p, parameters);
  return closed_form<F, 2, R>(t, p, parameters);
}

constexpr double pi_d = std::numbers::pi;

const Triangle<double> octant{Vec(1, 0, 0), Vec(0, 1, 0), Vec(0, 0, 1)};
const Triangle<double> flat{Vec(0, 0, 0), Vec(1, 0, 0), Vec(0, 1, 0)};

TEST(solid_angle, octant_is_an_eighth_of_the_sphere) {
  EXPECT_DOUBLE_EQ(evaluate<SolidAngle>(octant, Vec(0, 0, 0), 0).value[0], pi_d / 2);
}

TEST(solid_angle, positive_where_the_normal_points_away) {
  EXPECT_GT(evaluate<SolidAngle>(flat, Vec(0.2, 0.2, -1), 0).value[0], 0);
  EXPECT_LT(evaluate<SolidAngle>(flat, Vec(0.2, 0.2, 1), 0).value[0], 0);
}

TEST(solid_angle, limits_from_inside_on_the_triangle) {
  EXPECT_DOUBLE_EQ(evaluate<SolidAngle>(flat, Vec(0.25, 0.25, 0), 0).value[0], 2 * pi_d);
  EXPECT_DOUBLE_EQ(evaluate<SolidAngle>(flat, Vec(0.5, 0, 0), 0).value[0], pi_d);
  EXPECT_DOUBLE_EQ(evaluate<SolidAngle>(flat, Vec(0.5, 0.5, 0), 0).value[0], pi_d);
  EXPECT_DOUBLE_EQ(evaluate<SolidAngle>(flat, Vec(0, 0, 0), 0).value[0], pi_d / 2);
  EXPECT_DOUBLE_EQ(evaluate<SolidAngle>(flat, Vec(1, 0, 0), 0).value[0], pi_d / 4);
  EXPECT_EQ(evaluate<SolidAngle>(flat, Vec(2, 0, 0), 0).value[0], 0);
  EXPECT_EQ(evaluate<SolidAngle>(flat, Vec(2, 3, 0), 0).value[0], 0);
}

TEST(solid_angle, side_of_the_face_is_kept_next_to_it) {
  // Both heights are far below an ulp of the coordinates' products.
  Triangle<double> t{Vec(0, 0, 0), Vec(1, 0.5, 0.25), Vec(0.25, 1, 0.5)};
  const Vec n = t[1].cross(t[2]).normalized();
  const Vec middle = (t[0] + t[1] + t[2]) / 3;
  for (Vec& v : t) v -= middle;
  EXPECT_LT(evaluate<SolidAngle>(t, Vec(1e-16 * n), 0).value[0], -6.28);
  EXPECT_GT(evaluate<SolidAngle>(t, Vec(-1e-16 * n), 0).value[0], 6.28);
}

TEST(double_layer, half_the_hat_functions_on_the_face) {
  const auto phi = evaluate<DoubleLayer>(flat, Vec(0.25, 0.25, 0), 0);
  EXPECT_DOUBLE_EQ(phi.value[0], 0.25);
  EXPECT_DOUBLE_EQ(phi.value[1], 0.125);
  EXPECT_DOUBLE_EQ(phi.value[2], 0.125);
}

// Straight above a corner d phibar/dz is int Gamma (1/r - z^2/r^3)/(8 pi), whose terms cancel: int Gamma (x^2 + y^2)
// over 8 pi z^3 is left, 1/(240 pi z^3) for that corner.
TEST(biharmonic_double_layer, keeps_the_gradient_far_above_the_face) {
  for (const double z : {1e5, 1e7, 1e9}) {
    const double expected = 1 / (240 * std::numbers::pi * z * z * z);
    EXPECT_NEAR(evaluate<BiharmonicDoubleLayer>(flat, Vec(0, 0, z), 1).gradient[0][2], expected, 1e-9 * expected) << z;
  }
}

TEST(mean_value, infinite_on_the_face_and_zero_beside_it) {
  const auto on = evaluate<MeanValue>(flat, Vec(0.25, 0.25, 0), 0);
  for (const double w : on.value) EXPECT_TRUE(std::isinf(w) && w > 0);
  const auto beside = evaluate<MeanValue>(flat, Vec(2, 2, 0), 2);
  for (int k = 0; k < 3; ++k) {
    EXPECT_EQ(beside.value[k], 0);
    EXPECT_TRUE(beside.gradient[k].allFinite());
    EXPECT_NE(beside.gradient[k].norm(), 0);
    EXPECT_TRUE(beside.hessian[k].allFinite());
  }
}

// Next to an edge or a vertex the weight of a corner whose hat function vanishes there is any number, by the direction.
TEST(mean_value, has_no_limit_where_the_hat_function_vanishes) {
  for (const auto& [p, positive] : {std::pair{Vec(.5, 0, 0), std::array{true, true, false}},
                                    {Vec(.5, .5, 0), std::array{false, true, true}},
                                    {Vec(0, 1, 0), std::array{false, false, true}}}) {
    const auto on = evaluate<MeanValue>(flat, p, 0);
    for (int k = 0; k < 3; ++k) {
      if (positive[k]) {
        EXPECT_EQ(on.value[k], std::numeric_limits<double>::infinity()) << k;
      } else {
        EXPECT_TRUE(std::isnan(on.value[k])) << k;
      }
    }
  }
  const auto above = evaluate<MeanValue>(flat, Vec(.5, 0, -1e-9), 0),
             beside = evaluate<MeanValue>(flat, Vec(.5, 1e-9, -1e-9), 0);
  EXPECT_GT(std::abs(above.value[2] - beside.value[2]), .5);
}

TEST(mean_value, ratios_tend_to_the_hat_functions) {
  const auto w = evaluate<MeanValue>(flat, Vec(0.25, 0.25, -1e-9), 0);
  const double sum = w.value[0] + w.value[1] + w.value[2];
  EXPECT_NEAR(w.value[0] / sum, 0.5, 1e-8);
  EXPECT_NEAR(w.value[1] / sum, 0.25, 1e-8);
}

TEST(border, no_limit_is_not_a_number_and_what_exists_is_finite) {
  for (const Vec& p : {Vec(0.5, 0, 0), Vec(0, 0, 0), Vec(0.5, 0.5, 0)}) {
    EXPECT_TRUE(evaluate<DoubleLayer>(flat, p, 1).gradient[0].hasNaN());
    EXPECT_TRUE(evaluate<SolidAngle>(flat, p, 1).gradient[0].hasNaN());
    EXPECT_TRUE(evaluate<SingleLayer>(flat, p, 2).hessian[0].hasNaN());
    EXPECT_TRUE(evaluate<BiharmonicSingleLayer>(flat, p, 2).hessian[0].allFinite());
    EXPECT_TRUE(evaluate<BiharmonicDoubleLayer>(flat, p, 2).gradient[0].allFinite());
  }
}

// Every entry that is infinite on the border must be large and of that sign just inside.
template <class F>
void expect_sign_of_growth(int order, const Vec& on, std::span<const double> parameters = {}) {
  const auto limit = evaluate<F>(flat, on, order, parameters);
  const auto near = evaluate<F>(flat, Vec(on - Vec(0, 0, 1e-12)), order, parameters),
             nearer = evaluate<F>(flat, Vec(on - Vec(0, 0, 1e-13)), order, parameters);
  int infinite = 0;
  const auto look = [&](double at, double a, double b) {
    if (!std::isinf(at)) return;
    ++infinite;
    EXPECT_GT((b - a) * at, 0);
  };
  for (int c = 0; c < F::components; ++c) {
    if (order == 0) look(limit.value[c], near.value[c], nearer.value[c]);
    for (int i = 0; i < 3; ++i) {
      if (order == 1) look(limit.gradient[c][i], near.gradient[c][i], nearer.gradient[c][i]);
      for (int j = 0; order == 2 && j < 3; ++j)
        look(limit.hessian[c](i, j), near.hessian[c](i, j), nearer.hessian[c](i, j));
    }
  }
  EXPECT_GT(infinite, 0);
}

TEST(border, logarithms_are_infinite_with_their_sign) {
  const std::array<double, 2> elastic{1.5, 0.3};
  for (const Vec& p : {Vec(0.5, 0, 0), Vec(0, 0.25, 0), Vec(0.5, 0.5, 0), Vec(0, 0, 0)}) {
    expect_sign_of_growth<SingleLayer>(1, p);
    expect_sign_of_growth<AffineSingleLayer>(1, p);
    expect_sign_of_growth<BiharmonicDoubleLayer>(2, p);
    expect_sign_of_growth<KelvinDisplacement>(1, p, elastic);
    expect_sign_of_growth<KelvinTraction>(0, p, elastic);
  }
  const auto psi = evaluate<SingleLayer>(flat, Vec(0.5, 0, 0), 1);
  EXPECT_TRUE(std::isinf(psi.gradient[0][1]) && psi.gradient[0][1] > 0);
  EXPECT_TRUE(std::isfinite(psi.gradient[0][0]));
  EXPECT_DOUBLE_EQ(psi.gradient[0][2], 0.25);
}

// The logarithm's factor along z is the tilt, as far as 200 digits tell it from zero: the gradient is infinite towards
// the inside of the triangle.
TEST(border, logarithms_of_tilts_below_rounding_are_infinite_with_their_sign) {
  for (const double tilt : {0x1p-30, -0x1p-50, 0x1p-52, -0x1p-53, 0x1p-110, -0x1p-500, 0x1p-640}) {
    const Triangle<double> t{Vec(0, 0, 0), Vec(1, 0, 0), Vec(0, 1, tilt)};
    for (const Vec& p : {Vec(0.5, 0, 0), Vec(0, 0, 0)}) {
      const auto fast = evaluate<SingleLayer>(t, p, 1);
      const auto careful = accurate<SingleLayer, 1>(t, p, {});
      const double expected = tilt > 0 ? HUGE_VAL : -HUGE_VAL;
      EXPECT_EQ(fast.gradient[0][2], expected) << tilt;
      EXPECT_EQ(careful.jet.gradient[0][2], expected) << tilt;
      EXPECT_EQ(fast.gradient[0][1], HUGE_VAL);
    }
  }
}

// In the incompressible limit no logarithm is left in T, whose value then has a limit on the border.
TEST(border, incompressible_traction_has_its_limit_from_inside) {
  const std::array<double, 2> elastic{1, 0.5};
  for (const Vec& p : {Vec(0.5, 0, 0), Vec(0, 0.25, 0), Vec(0.5, 0.5, 0), Vec(0, 0, 0), Vec(1, 0, 0), Vec(0, 1, 0)}) {
    const auto on = evaluate<KelvinTraction, double>(flat, p, 0, elastic);
    const auto inside = evaluate<KelvinTraction, double>(flat, Vec(p - Vec(0, 0, 1e-9)), 0, elastic);
    for (int c = 0; c < KelvinTraction::components; ++c) EXPECT_NEAR(on.value[c], inside.value[c], 1e-7) << c;
  }
}

TEST(values, finite_at_every_special_position) {
  for (const Vec& p :
       {Vec(0, 0, 0), Vec(1, 0, 0), Vec(0, 1, 0), Vec(0.5, 0, 0), Vec(2, 0, 0), Vec(-1, 0, 0), Vec(0, -3, 0),
        Vec(-1, 2, 0), Vec(0.25, 0.25, 0), Vec(0, 0, 1), Vec(1, 0, -1e-300), Vec(1e-200, 0, 0)}) {
    EXPECT_TRUE(std::isfinite(evaluate<SingleLayer>(flat, p, 0).value[0]));
    EXPECT_TRUE(std::isfinite(evaluate<SolidAngle>(flat, p, 0).value[0]));
    EXPECT_TRUE(std::isfinite(evaluate<DoubleLayer>(flat, p, 0).value[1]));
    EXPECT_TRUE(std::isfinite(evaluate<BiharmonicSingleLayer>(flat, p, 0).value[0]));
    EXPECT_TRUE(std::isfinite(evaluate<BiharmonicDoubleLayer>(flat, p, 0).value[1]));
  }
}

TEST(scaling, extreme_units_neither_overflow_nor_underflow) {
  const Vec p(0.3, 0.1, -0.4);
  for (const double unit : {1e-100, 1e100}) {
    const Triangle<double> t{Vec(unit * flat[0]), Vec(unit * flat[1]), Vec(unit * flat[2])};
    EXPECT_NEAR(
        evaluate<SingleLayer>(t, Vec(unit * p), 0).value[0] / (unit * evaluate<SingleLayer>(flat, p, 0).value[0]), 1,
        1e-14);
    EXPECT_NEAR(evaluate<SolidAngle>(t, Vec(unit * p), 0).value[0], evaluate<SolidAngle>(flat, p, 0).value[0], 1e-14);
    EXPECT_NEAR(evaluate<DoubleLayer>(t, Vec(unit * p), 1).gradient[1].norm() * unit /
                    evaluate<DoubleLayer>(flat, p, 1).gradient[1].norm(),
                1, 1e-13);
  }
}

TEST(far_away, single_layers_keep_their_digits) {
  const Vec p(3e7, 4e7, 1.2e8);
  const Triangle<Mp100> wide{convert<Mp100>(flat[0]), convert<Mp100>(flat[1]), convert<Mp100>(flat[2])};
  const auto exact = evaluate<SingleLayer, Mp100>(wide, convert<Mp100>(p), 1);
  const auto found = evaluate<SingleLayer>(flat, p, 1);
  EXPECT_NEAR(found.value[0] / static_cast<double>(exact.value[0]), 1, 2e-15);
  const Vec gradient = convert<double>(Vec3<Mp100>(exact.gradient[0]));
  EXPECT_LT((found.gradient[0] - gradient).norm(), 1e-14 * gradient.norm());
}

}  // namespace
}  // namespace cageproof::closed_form::triangle::potentials_test
