// SPDX-License-Identifier: MIT
// Closed forms on segments against the integrals of their kernels, and in double against themselves in 100 digits.
#include "cageproof/closed_form/segment/affine_single_layer.h"
#include "cageproof/closed_form/segment/biharmonic_double_layer.h"
#include "cageproof/closed_form/segment/biharmonic_single_layer.h"
#include "cageproof/closed_form/segment/double_layer.h"
#include "cageproof/closed_form/segment/engine/closed_form.h"
#include "cageproof/closed_form/segment/mean_value.h"
#include "cageproof/closed_form/segment/single_layer.h"
#include "cageproof/closed_form/segment/winding_angle.h"
#include "cageproof/core/catalogue/evaluation.h"
#include "segment_truth.h"

#include <numbers>

namespace cageproof::closed_form::segment::segment_test {
namespace {

using Vec = Vec3<double>;

TEST(segment_single_layer, is_the_kernels_integral_in_all_regimes) {
  expect_exact_in_all_regimes<SingleLayer, SingleKernel>({6, 6, 6});
}
TEST(segment_double_layer, is_the_kernels_integral_in_all_regimes) {
  expect_exact_in_all_regimes<DoubleLayer, DoubleKernel>({6, 6, 6});
}

TEST(segment_affine_single_layer, is_the_kernels_integral_in_all_regimes) {
  expect_exact_in_all_regimes<AffineSingleLayer, OfHats<SingleKernel>>({8, 6, 6});
}
TEST(segment_mean_value, is_the_kernels_integral_in_all_regimes) {
  expect_exact_in_all_regimes<MeanValue, OfHats<MeanValueKernel>>({8, 8, 8});
}
TEST(segment_winding_angle, is_the_kernels_integral_in_all_regimes) {
  expect_exact_in_all_regimes<WindingAngle, AngleKernel>({6, 6, 6});
}

TEST(segment_biharmonic_single_layer, is_the_kernels_integral_in_all_regimes) {
  expect_exact_in_all_regimes<BiharmonicSingleLayer, BiharmonicKernel>({12, 8, 8});
}
TEST(segment_biharmonic_double_layer, is_the_kernels_integral_in_all_regimes) {
  expect_exact_in_all_regimes<BiharmonicDoubleLayer, OfHats<BiharmonicHeightKernel>>({8, 8, 8});
}

const Segment<double> unit{Vec(0, 0, 0), Vec(1, 0, 0)};  // the inside is where y > 0

template <class F, int O>
Tensors<F, double> at(double x, double y) {
  return closed_form<F, O, double>(unit, Vec(x, y, 0));
}

TEST(segment_single_layer, values_and_limits_from_inside_on_the_segment) {
  const double turn = 0.5 / std::numbers::pi;
  const auto middle = at<SingleLayer, 2>(0.5, 0);
  EXPECT_DOUBLE_EQ(middle.value[0], turn * (1 + std::numbers::ln2));
  EXPECT_EQ(middle.gradient[0][0], 0);
  EXPECT_DOUBLE_EQ(middle.gradient[0][1], -0.5);  // the normal is (0, -1)
  EXPECT_DOUBLE_EQ(middle.hessian[0](0, 0), -4 * turn);
  const double next = std::numeric_limits<double>::denorm_min();
  EXPECT_DOUBLE_EQ((at<SingleLayer, 1>(0.5, next).gradient[0][1]), -0.5);
  EXPECT_DOUBLE_EQ((at<SingleLayer, 1>(0.5, -next).gradient[0][1]), 0.5);
  EXPECT_DOUBLE_EQ((at<SingleLayer, 0>(0, 0).value[0]), turn);
  EXPECT_DOUBLE_EQ((at<SingleLayer, 0>(1, 0).value[0]), turn);
  EXPECT_DOUBLE_EQ((at<SingleLayer, 1>(2, 0).gradient[0][0]), -turn * std::numbers::ln2);
  EXPECT_EQ((at<SingleLayer, 1>(2, 0).gradient[0][1]), 0);
}

TEST(segment_single_layer, ends_have_a_value_and_infinite_slopes) {
  const auto first = at<SingleLayer, 2>(0, 0), last = at<SingleLayer, 2>(1, 0);
  EXPECT_EQ(first.gradient[0][0], std::numeric_limits<double>::infinity());
  EXPECT_EQ(last.gradient[0][0], -std::numeric_limits<double>::infinity());
  EXPECT_DOUBLE_EQ(first.gradient[0][1], -0.25);
  EXPECT_DOUBLE_EQ(last.gradient[0][1], -0.25);
  EXPECT_TRUE(first.hessian[0].array().isNaN().all());
  // The truth next to it, on the inner side.
  const auto inside = at<SingleLayer, 1>(0, 1e-12);
  EXPECT_GT(inside.gradient[0][0], 4);
  EXPECT_NEAR(inside.gradient[0][1], -0.25, 1e-11);
  const Segment<double> slanted{Vec(1, 1, 0), Vec(2, 3, 0)};
  const auto end = closed_form<SingleLayer, 1, double>(slanted, Vec(1, 1, 0));
  EXPECT_TRUE(std::isfinite(end.value[0]));
  for (int i = 0; i < 2; ++i) EXPECT_EQ(end.gradient[0][i], std::numeric_limits<double>::infinity());
}

TEST(segment_double_layer, half_the_hat_functions_on_the_segment_and_nothing_beyond) {
  const auto on = at<DoubleLayer, 1>(0.25, 0);
  EXPECT_DOUBLE_EQ(on.value[0], 0.375);
  EXPECT_DOUBLE_EQ(on.value[1], 0.125);
  EXPECT_TRUE(on.gradient[0].allFinite());
  EXPECT_DOUBLE_EQ((at<DoubleLayer, 0>(0.25, -1e-300).value[0]), -0.375);
  const auto end = at<DoubleLayer, 1>(0, 0);
  EXPECT_DOUBLE_EQ(end.value[0], 0.25);
  EXPECT_EQ(end.value[1], 0);
  EXPECT_TRUE(end.gradient[0].array().isNaN().all());
  for (const double x : {2.0, -3.0, 1e9}) {
    EXPECT_EQ((at<DoubleLayer, 0>(x, 0).value[0]), 0);
    EXPECT_EQ((at<DoubleLayer, 0>(x, 0).value[1]), 0);
  }
}

TEST(segment_affine_single_layer, ends_have_values_and_one_infinite_slope) {
  const double turn = 0.5 / std::numbers::pi;
  const auto first = at<AffineSingleLayer, 2>(0, 0), last = at<AffineSingleLayer, 2>(1, 0);
  // int (1 - t) ln t = -3/4, int t ln t = -1/4
  EXPECT_DOUBLE_EQ(first.value[0], 0.75 * turn);
  EXPECT_DOUBLE_EQ(first.value[1], 0.25 * turn);
  EXPECT_DOUBLE_EQ(last.value[0], 0.25 * turn);
  EXPECT_DOUBLE_EQ(last.value[1], 0.75 * turn);
  EXPECT_EQ(first.gradient[0][0], std::numeric_limits<double>::infinity());
  EXPECT_EQ(last.gradient[1][0], -std::numeric_limits<double>::infinity());
  EXPECT_DOUBLE_EQ(first.gradient[0][1], -0.25);
  EXPECT_DOUBLE_EQ(first.gradient[1][0], turn);
  EXPECT_EQ(first.gradient[1][1], 0);
  EXPECT_DOUBLE_EQ(last.gradient[0][0], -turn);
  for (const auto& end : {first, last})
    for (int k = 0; k < 2; ++k) EXPECT_TRUE(end.hessian[k].array().isNaN().all());
}

TEST(segment_biharmonic_single_layer, has_all_limits_at_the_ends) {
  const double turn = 0.125 / std::numbers::pi;
  const auto first = at<BiharmonicSingleLayer, 2>(0, 0);
  // int t^2 (ln t - 1) = -4/9, int t (2 ln t - 1) = -1, int 2 ln t = -2
  EXPECT_DOUBLE_EQ(first.value[0], turn * 4 / 9);
  EXPECT_DOUBLE_EQ(first.gradient[0][0], -turn);
  EXPECT_EQ(first.gradient[0][1], 0);
  EXPECT_DOUBLE_EQ(first.hessian[0](0, 0), turn);
  EXPECT_DOUBLE_EQ(first.hessian[0](1, 1), 3 * turn);
  EXPECT_EQ(first.hessian[0](0, 1), 0);
}

TEST(segment_biharmonic_double_layer, is_zero_on_the_line_and_has_one_infinite_curvature) {
  for (const double x : {0.0, 0.25, 1.0, 2.0, -1e9})
    for (int k = 0; k < 2; ++k) EXPECT_EQ((at<BiharmonicDoubleLayer, 0>(x, 0).value[k]), 0);
  const double turn = 0.125 / std::numbers::pi;
  const auto first = at<BiharmonicDoubleLayer, 2>(0, 0);
  // 2 int (1 - t) ln t - 1/2 = -2, 2 int t ln t - 1/2 = -1; the normal is (0, -1)
  EXPECT_DOUBLE_EQ(first.gradient[0][1], -2 * turn);
  EXPECT_DOUBLE_EQ(first.gradient[1][1], -turn);
  EXPECT_EQ(first.gradient[0][0], 0);
  EXPECT_EQ(first.hessian[0](0, 1), -std::numeric_limits<double>::infinity());
  EXPECT_TRUE(std::isnan(first.hessian[0](0, 0)));
  EXPECT_DOUBLE_EQ(first.hessian[1](0, 1), -2 * turn);
  EXPECT_EQ(first.hessian[1](1, 1), 0);
  // Next to it, on the inner side.
  const auto inside = at<BiharmonicDoubleLayer, 2>(0, 1e-12);
  EXPECT_LT(inside.hessian[0](0, 1), -40 * turn);
  EXPECT_NEAR(inside.hessian[1](0, 1), -2 * turn, 1e-9);
}

// Over the middle what differs between the ends is far below either: of the gradient, h from the middle along the line,
// int x (2 ln r - 1) = h length (2 ln(length/2) - 2 + 1) + O(h^2) is left.
TEST(segment_biharmonic_single_layer, keeps_its_gradient_over_the_middle) {
  const Segment<double> s{Vec(1, 0, 0), Vec(-1, 0, 0)};
  for (const double h : {1e-10, 1e-15})
    EXPECT_DOUBLE_EQ((closed_form<BiharmonicSingleLayer, 1, double>(s, Vec(h, 0, 0)).gradient[0][0]),
                     h / (4 * std::numbers::pi));
  const auto wide = closed_form<BiharmonicSingleLayer, 1, Mp100>({convert<Mp100>(s[0]), convert<Mp100>(s[1])},
                                                                 Vec3<Mp100>(Mp100("1e-200"), Mp100(0), Mp100(0)));
  EXPECT_DOUBLE_EQ(static_cast<double>(wide.gradient[0][0]), 1e-200 / (4 * std::numbers::pi));
}

TEST(segment_mean_value, diverges_on_the_segment_and_vanishes_beyond) {
  const double infinity = std::numeric_limits<double>::infinity();
  // Over the middle tan(45 degrees) over the distance.
  EXPECT_DOUBLE_EQ((at<MeanValue, 0>(0.5, 0.5).value[0]), std::numbers::sqrt2);
  const auto on = at<MeanValue, 2>(0.25, 0), end = at<MeanValue, 1>(0, 0);
  for (int k = 0; k < 2; ++k) {
    EXPECT_EQ(on.value[k], infinity);
    EXPECT_TRUE(on.gradient[k].array().isNaN().all() && on.hessian[k].array().isNaN().all());
    EXPECT_EQ((at<MeanValue, 0>(2, 0).value[k]), 0);
  }
  EXPECT_EQ(end.value[0], infinity);
  EXPECT_TRUE(std::isnan(end.value[1]));
  EXPECT_DOUBLE_EQ((at<MeanValue, 0>(0.25, 1e-200).value[0]), 1.5e200);
  EXPECT_DOUBLE_EQ((at<MeanValue, 0>(0.25, -1e-200).value[1]), -5e199);
}

TEST(segment_winding_angle, pi_on_the_segment_and_nothing_beyond) {
  EXPECT_DOUBLE_EQ((at<WindingAngle, 0>(0.25, 0).value[0]), std::numbers::pi);
  EXPECT_DOUBLE_EQ((at<WindingAngle, 0>(0.25, -1e-300).value[0]), -std::numbers::pi);
  EXPECT_DOUBLE_EQ((at<WindingAngle, 0>(0.5, 0.5).value[0]), std::numbers::pi / 2);
  const auto end = at<WindingAngle, 2>(0, 0);
  EXPECT_DOUBLE_EQ(end.value[0], std::numbers::pi / 2);
  EXPECT_TRUE(end.gradient[0].array().isNaN().all());
  EXPECT_TRUE(end.hessian[0].array().isNaN().all());
  EXPECT_EQ((at<WindingAngle, 0>(2, 0).value[0]), 0);
}

// In every scalar the limits are taken from the same side.
TEST(segment, sides_agree_in_all_scalars) {
  for (const double x : {0.25, 0.5, 0.0, 1.0}) {
    const auto in_double = at<DoubleLayer, 0>(x, 0);
    const auto wide = closed_form<DoubleLayer, 0, Mp100>({convert<Mp100>(unit[0]), convert<Mp100>(unit[1])},
                                                         Vec3<Mp100>(Mp100(x), Mp100(0), Mp100(0)));
    const auto small = closed_form<DoubleLayer, 0, float>({convert<float>(unit[0]), convert<float>(unit[1])},
                                                          Vec3<float>(static_cast<float>(x), 0, 0));
    for (int k = 0; k < 2; ++k) {
      EXPECT_DOUBLE_EQ(in_double.value[k], static_cast<double>(wide.value[k]));
      EXPECT_FLOAT_EQ(static_cast<float>(in_double.value[k]), small.value[k]);
    }
  }
}

// Next to an end at the smallest distances that doubles have, the direction is still that of the point.
TEST(segment, directions_are_kept_at_the_smallest_distances) {
  const Segment<double> s{Vec(0, 0, 0), Vec(0.75, 0.5, 0)};
  for (const double d : {1e-160, 1e-200, 1e-300, 1e-320, 5e-324})
    for (const Vec& way : {Vec(1, 1, 0), Vec(-1, 1, 0), Vec(0, -1, 0), Vec(-1, 0, 0)}) {
      const SegmentSample sample{s, Vec(d * way)};
      for (int o = 0; o <= 1; ++o) {
        EXPECT_LE(conditioned_error<SingleLayer>(sample, o), 16) << d << ", order " << o;
      }
      EXPECT_LE(conditioned_error<DoubleLayer>(sample, 0), 16) << d;
      // Below, the Hessian exceeds a double's range.
      if (d >= 1e-300) {
        EXPECT_LE(conditioned_error<SingleLayer>(sample, 2), 16) << d;
      }
    }
}

// The registered evaluation takes more digits only at extreme points: elsewhere it has the closed form's bits.
template <class F>
void expect_registered(const char* formula) {
  const Evaluation registered = evaluation_named(formula, "closed_form");
  int samples = 0;
  for (const auto& [regime, make] : segment_regimes()) {
    if (regime != "generic" && regime != "near-face") continue;
    for (int i = 0; i < 12; ++i, ++samples) {
      const SegmentSample sample = make(i);
      const auto expected = evaluate<F, double>(sample);
      Result<double> found;
      registered(Query<double>{sample.s, sample.point, 2}, found);
      for (int o = 0; o <= 2; ++o) EXPECT_EQ(found.of(o), part(expected, o)) << regime << ' ' << i << ", order " << o;
    }
  }
  EXPECT_EQ(samples, 24);
}

TEST(segment, registered_evaluations_have_the_bits_of_the_closed_forms) {
  expect_registered<SingleLayer>("segment.single_layer");
  expect_registered<DoubleLayer>("segment.double_layer");
  expect_registered<AffineSingleLayer>("segment.affine_single_layer");
  expect_registered<BiharmonicSingleLayer>("segment.biharmonic_single_layer");
  expect_registered<BiharmonicDoubleLayer>("segment.biharmonic_double_layer");
  expect_registered<MeanValue>("segment.mean_value");
  expect_registered<WindingAngle>("segment.winding_angle");
}

}  // namespace
}  // namespace cageproof::closed_form::segment::segment_test
