// SPDX-License-Identifier: MIT
// Closed forms on segments against the integrals of their kernels, and in double against themselves in 100 digits.
#include "cageproof/closed_form/segment/double_layer.h"
#include "cageproof/closed_form/segment/single_layer.h"
#include "cageproof/core/evaluation.h"
#include "segment_samples.h"

#include <gtest/gtest.h>

#include <numbers>

namespace cageproof::closed_form::segment {
namespace {

using Vec = Vec3<double>;

template <class F, Scalar R>
using Tensors = Jet<R, F::components, 2>;

// The parts of derivative order o, one number after the other.
template <Scalar R, int C>
std::vector<R> part(const Jet<R, C, 2>& jet, int order) {
  std::vector<R> x;
  for (int c = 0; c < C; ++c) {
    if (order == 0) x.push_back(jet.value[c]);
    for (int i = 0; i < 2; ++i) {
      if (order == 1) x.push_back(jet.gradient[c][i]);
      for (int j = 0; order == 2 && j < 2; ++j) x.push_back(jet.hessian[c](i, j));
    }
  }
  return x;
}

template <Scalar R>
R norm(const std::vector<R>& x) {
  R sum = 0;
  for (const R& y : x) sum += y * y;
  using std::sqrt;
  return sqrt(sum);
}

template <Scalar R, Scalar S>
std::vector<R> difference(const std::vector<R>& a, const std::vector<S>& b) {
  std::vector<R> d;
  for (std::size_t i = 0; i < a.size(); ++i) d.push_back(R(a[i]) - R(b[i]));
  return d;
}

template <class F, Scalar R>
Tensors<F, R> evaluate(const SegmentSample& sample) {
  return closed_form<F, 2, R>({convert<R>(sample.s[0]), convert<R>(sample.s[1])}, convert<R>(sample.point));
}

// The kernels, times 2 pi, and their derivatives with respect to the point; x = xi - eta.
struct SingleKernel {
  static constexpr int components = 1;
  static void add(const Mp100& weight, const Mp100&, const Mp100& x, const Mp100& y, const Mp100&, const Mp100&,
                  Jet<Mp100, 1, 2>& sum) {
    const Mp100 q = 1 / (x * x + y * y);
    sum.value[0] += weight * log(q) / 2;
    sum.gradient[0] += weight * q * Eigen::Matrix<Mp100, 2, 1>(x, y);
    const Mp100 d = weight * q * q * (x * x - y * y), m = weight * q * q * 2 * x * y;
    sum.hessian[0](0, 0) += d;
    sum.hessian[0](1, 1) -= d;
    sum.hessian[0](0, 1) += m;
    sum.hessian[0](1, 0) += m;
  }
};
struct DoubleKernel {
  static constexpr int components = 2;
  static void add(const Mp100& weight, const Mp100& t, const Mp100& x, const Mp100& y, const Mp100& nx, const Mp100& ny,
                  Jet<Mp100, 2, 2>& sum) {
    const Mp100 q = 1 / (x * x + y * y), height = x * nx + y * ny;
    const std::array<Mp100, 2> v{x, y}, n{nx, ny};
    for (int k = 0; k < 2; ++k) {
      const Mp100 hat = weight * (k == 0 ? Mp100(1 - t) : t);
      sum.value[k] += hat * height * q;
      for (int i = 0; i < 2; ++i) {
        sum.gradient[k][i] -= hat * q * (n[i] - 2 * height * v[i] * q);
        for (int j = 0; j < 2; ++j)
          sum.hessian[k](i, j) +=
              hat * q * q *
              (8 * height * v[i] * v[j] * q - 2 * (n[i] * v[j] + n[j] * v[i]) - (i == j ? 2 * height : Mp100(0)));
      }
    }
  }
};

// The integral over panels that double away from the point of the segment that is nearest. Their integrands are
// analytic one panel's length around.
template <class K>
Jet<Mp100, K::components, 2> integral(const SegmentSample& sample) {
  const auto& rule = gauss_legendre<Mp100>(60);
  const Vec3<Mp100> a = convert<Mp100>(sample.s[0]), e = convert<Mp100>(sample.s[1]) - a,
                    from = convert<Mp100>(sample.point) - a;
  const Mp100 length = sqrt(Mp100(e.dot(e))), nx = e[1] / length, ny = -e[0] / length;
  const Mp100 nearest = std::clamp(Mp100(from.dot(e) / e.dot(e)), Mp100(0), Mp100(1));
  const Vec3<Mp100> arm = from - nearest * e;
  const Mp100 first = sqrt(Mp100(arm.dot(arm))) / length;
  Jet<Mp100, K::components, 2> sum;
  for (const int side : {-1, 1}) {
    const Mp100 whole = side > 0 ? Mp100(1 - nearest) : nearest;
    Mp100 begin = 0, width = first;
    while (begin < whole) {
      const Mp100 end = std::min(Mp100(begin + width), whole);
      for (std::size_t j = 0; j < rule.nodes.size(); ++j) {
        const Mp100 step = side * (begin + (end - begin) * rule.nodes[j]), t = nearest + step;
        // From the nearest point, where differences are small.
        K::add(rule.weights[j] * (end - begin) * length, t, step * e[0] - arm[0], step * e[1] - arm[1], nx, ny, sum);
      }
      begin = end;
      width *= 2;
    }
  }
  const Mp100 turn = 1 / (2 * pi<Mp100>());
  for (int c = 0; c < K::components; ++c) {
    sum.value[c] *= turn;
    sum.gradient[c] *= turn;
    sum.hessian[c] *= turn;
  }
  return sum;
}

template <class F, class K>
void expect_integral(const SegmentSample& sample, const std::string& what) {
  const auto found = evaluate<F, Mp100>(sample);
  const auto truth = integral<K>(sample);
  for (int o = 0; o <= 2; ++o) {
    const auto t = part(truth, o);
    EXPECT_LE(static_cast<double>(norm(difference<Mp100>(t, part(found, o))) / norm(t)), 1e-30)
        << what << ", order " << o;
  }
}

// The conditioned error of an order in units of u; `moved` are the differences for a step of each input, over the step,
// times the input.
template <class F>
double conditioned_error(const SegmentSample& sample, int order) {
  const auto truth = part(evaluate<F, Mp100>(sample), order);
  Mp100 size = norm(truth);
  const Mp100 step("1e-60");
  std::array<Vec3<Mp100>, 3> inputs{convert<Mp100>(sample.s[0]), convert<Mp100>(sample.s[1]),
                                    convert<Mp100>(sample.point)};
  for (Vec3<Mp100>& v : inputs)
    for (int c = 0; c < 2; ++c) {
      const Mp100 kept = v[c], move = step * kept;
      if (kept == 0) continue;
      v[c] = kept + move;
      const auto moved = part(closed_form<F, 2, Mp100>({inputs[0], inputs[1]}, inputs[2]), order);
      v[c] = kept;
      size += norm(difference<Mp100>(moved, truth)) / step;
    }
  const auto found = part(evaluate<F, double>(sample), order);
  const double error =
      static_cast<double>(Mp100(norm(difference<Mp100>(truth, found)) / size / Mp100(unit_roundoff<double>())));
  return std::isnan(error) ? std::numeric_limits<double>::infinity() : error;
}

template <class F, class K>
void expect_exact_in_all_regimes(std::array<double, 3> promise) {
  for (const auto& [name, make] : segment_regimes()) {
    std::array<double, 3> worst{};
    for (int i = 0; i < 96; ++i) {
      const SegmentSample sample = make(i);
      if (i % 13 == 0) expect_integral<F, K>(sample, name + ", sample " + std::to_string(i));
      for (int o = 0; o <= 2; ++o) worst[o] = std::max(worst[o], conditioned_error<F>(sample, o));
    }
    for (int o = 0; o <= 2; ++o) EXPECT_LE(worst[o], promise[o]) << name << ", order " << o;
    testing::Test::RecordProperty(
        name, std::to_string(worst[0]) + " " + std::to_string(worst[1]) + " " + std::to_string(worst[2]));
  }
}

TEST(segment_single_layer, is_the_kernels_integral_in_all_regimes) {
  expect_exact_in_all_regimes<SingleLayer, SingleKernel>({6, 6, 6});
}
TEST(segment_double_layer, is_the_kernels_integral_in_all_regimes) {
  expect_exact_in_all_regimes<DoubleLayer, DoubleKernel>({6, 6, 6});
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

// The registered evaluation goes to more digits at extreme points alone: elsewhere it has the closed form's bits.
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
}

}  // namespace
}  // namespace cageproof::closed_form::segment
