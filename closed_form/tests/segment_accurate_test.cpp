// SPDX-License-Identifier: MIT
// `accurate` on segments: every order to its relative promise, within its own statement, against the kernels'
// integrals, and in the limits that closed forms have.
#include "cageproof/closed_form/arithmetic/spacing.h"
#include "cageproof/closed_form/segment/affine_single_layer.h"
#include "cageproof/closed_form/segment/biharmonic_double_layer.h"
#include "cageproof/closed_form/segment/biharmonic_single_layer.h"
#include "cageproof/closed_form/segment/double_layer.h"
#include "cageproof/closed_form/segment/engine/closed_form.h"
#include "cageproof/closed_form/segment/engine/plain.h"
#include "cageproof/closed_form/segment/kelvin_displacement.h"
#include "cageproof/closed_form/segment/mean_value.h"
#include "cageproof/closed_form/segment/single_layer.h"
#include "cageproof/closed_form/segment/winding_angle.h"
#include "cageproof/core/catalogue/evaluation.h"
#include "segment_kernels.h"

#include <gtest/gtest.h>

namespace cageproof::closed_form::segment::segment_accurate_test {
namespace {

using Vec = Vec3<double>;

// The error of an order over the truth's norm.
template <int C>
double relative_error(const Jet<Mp100, C, 2>& truth, const Jet<double, C, 2>& found, int order) {
  const auto t = part(truth, order);
  return static_cast<double>(Mp100(norm(difference<Mp100>(t, part(found, order))) / norm(t)));
}

template <class F, class K>
void expect_what_is_stated(const SegmentSample& sample, const std::string& what) {
  const auto found = accurate<F, 2>(sample.s, sample.point);
  const auto truth = integral<K>(sample);
  for (int o = 0; o <= 2; ++o) {
    const double error = relative_error(truth, found.jet, o);
    EXPECT_LE(error, found.bound[o]) << what << ", order " << o;
    EXPECT_LE(found.bound[o], kAccurateTolerance) << what << ", order " << o;
  }
}

template <class F, class K>
void expect_what_is_stated_in_all_regimes() {
  for (const auto& [name, make] : segment_regimes())
    for (int i = 0; i < 96; i += 11) expect_what_is_stated<F, K>(make(i), name + ", sample " + std::to_string(i));
}

TEST(segment_accurate, is_as_good_as_stated) {
  expect_what_is_stated_in_all_regimes<SingleLayer, SingleKernel>();
  expect_what_is_stated_in_all_regimes<AffineSingleLayer, OfHats<SingleKernel>>();
  expect_what_is_stated_in_all_regimes<DoubleLayer, DoubleKernel>();
  expect_what_is_stated_in_all_regimes<BiharmonicSingleLayer, BiharmonicKernel>();
  expect_what_is_stated_in_all_regimes<BiharmonicDoubleLayer, OfHats<BiharmonicHeightKernel>>();
  expect_what_is_stated_in_all_regimes<MeanValue, OfHats<MeanValueKernel>>();
  expect_what_is_stated_in_all_regimes<WindingAngle, AngleKernel>();
}

// Over the middle of a segment that is as long, the potential is zero where ln r is one of its mean. No closed form in
// double has a digit of it there.
TEST(segment_accurate, has_its_digits_where_a_potential_is_all_but_zero) {
  double low = 0.5, high = 2;
  const auto sample_of = [](double height) {
    return SegmentSample{{Vec(-0.5, 0, 0), Vec(0.5, 0, 0)}, Vec(0, height, 0)};
  };
  while (true) {
    const double middle = (low + high) / 2;
    if (middle == low || middle == high) break;
    (integral<SingleKernel>(sample_of(middle)).value[0] > 0 ? low : high) = middle;
  }
  const SegmentSample sample = sample_of(low);
  const auto truth = integral<SingleKernel>(sample);
  ASSERT_LT(abs(truth.value[0]), Mp100("1e-16"));
  const auto rough = plain<SingleLayer, 0>(sample.s, sample.point);
  EXPECT_GT(relative_error(truth, rough, 0), 1e-6);
  expect_what_is_stated<SingleLayer, SingleKernel>(sample, "next to a zero");
}

// Limits of closed forms, entry by entry: infinities with their signs, zeros, and NaN where no limit exists.
template <class F>
void expect_limits(const Segment<double>& s, const Vec& eta) {
  const auto found = accurate<F, 2>(s, eta).jet;
  const auto plain = closed_form<F, 2, Mp100>({convert<Mp100>(s[0]), convert<Mp100>(s[1])}, convert<Mp100>(eta));
  for (int o = 0; o <= 2; ++o) {
    const auto a = part(found, o);
    const auto b = part(plain, o);
    double size = 0;
    for (const Mp100& x : b)
      if (isfinite(x)) size = std::hypot(size, static_cast<double>(x));
    for (std::size_t i = 0; i < a.size(); ++i) {
      const auto expected = static_cast<double>(b[i]);
      const bool finite = std::isfinite(expected);
      const bool same = a[i] == expected || (std::isnan(a[i]) && std::isnan(expected)) ||
                        (finite && expected != 0 && std::abs(a[i] - expected) <= 1e-14 * size);
      EXPECT_TRUE(same) << a[i] << " for " << expected << ", order " << o << ", entry " << i << " at "
                        << eta.transpose();
    }
  }
}

template <class... F>
void expect_limits_of() {
  const Segment<double> flat{Vec(0, 0, 0), Vec(1, 0, 0)}, slanted{Vec(1, 1, 0), Vec(2, 3, 0)};
  for (const auto& s : {flat, slanted})
    for (const double t : {0., 1., 0.5, 0.25, 2., -3.}) (expect_limits<F>(s, Vec(s[0] + t * (s[1] - s[0]))), ...);
}

TEST(segment_accurate, has_the_closed_forms_limits_on_the_line) {
  expect_limits_of<SingleLayer, AffineSingleLayer, DoubleLayer, BiharmonicSingleLayer, BiharmonicDoubleLayer, MeanValue,
                   WindingAngle>();
}

TEST(segment_accurate, states_nothing_relative_of_an_exact_zero) {
  const auto on_line = accurate<DoubleLayer, 0>({Vec(0, 0, 0), Vec(1, 0, 0)}, Vec(3, 0, 0));
  EXPECT_EQ(on_line.jet.value[0], 0);
  EXPECT_EQ(on_line.bound[0], 0);
}

// Distances at the ends of the exponents' range: an angle of 1e-300, and weights of 1e300.
TEST(segment_accurate, keeps_its_digits_at_the_ends_of_the_range) {
  const auto angle = accurate<WindingAngle, 0>({Vec(0, 0, 0), Vec(1, 0, 0)}, Vec(2, 1e-300, 0));
  EXPECT_DOUBLE_EQ(angle.jet.value[0], 5e-301);  // height (1/1 - 1/2)
  EXPECT_LE(angle.bound[0], kAccurateTolerance);
  const auto weights = accurate<MeanValue, 0>({Vec(-1, 0, 0), Vec(1, 0, 0)}, Vec(0, 1e-300, 0));
  EXPECT_DOUBLE_EQ(weights.jet.value[0], 1e300);  // half of 2/height
  EXPECT_LE(weights.bound[0], kAccurateTolerance);
  // Off the line by less than a double holds: on its outer side.
  const double least = std::numeric_limits<double>::denorm_min();
  const auto outside = accurate<MeanValue, 0>({Vec(1, 2, 0), Vec(-1, -2, 0)}, Vec(-least, 0, 0));
  for (const double w : outside.jet.value) EXPECT_EQ(w, -std::numeric_limits<double>::infinity());
}

// omega = pi - 2 y (1 + x^2) + 2 y^3/3 + ... about the middle of a segment from -1 to 1: its Hessian vanishes there.
// The next terms are smaller by x^2.
TEST(segment_accurate, sees_the_angles_hessian_vanish_at_the_middle) {
  const Segment<double> s{Vec(-1, 0, 0), Vec(1, 0, 0)};
  for (const double size : {1e-7, 1e-40, 1e-120, 1e-230, 1e-300}) {
    const double x = 3 * size, y = 0.5 * size;
    const auto found = accurate<WindingAngle, 2>(s, Vec(x, y, 0));
    const auto wide =
        closed_form<WindingAngle, 2, Mp100>({convert<Mp100>(s[0]), convert<Mp100>(s[1])}, convert<Mp100>(Vec(x, y, 0)));
    const std::array<double, 4> hessian{-4 * y, -4 * x, -4 * x, 4 * y};
    EXPECT_LE(found.bound[2], kAccurateTolerance) << size;
    for (int i = 0; i < 4; ++i) {
      EXPECT_NEAR(found.jet.hessian[0](i / 2, i % 2), hessian[i], 1e-8 * size) << size;
      EXPECT_NEAR(static_cast<double>(wide.hessian[0](i / 2, i % 2)), hessian[i], 1e-8 * size) << size;
    }
  }
}

// In float the statement holds of what is rounded to float.
TEST(segment_accurate, states_its_error_in_float) {
  const Evaluation evaluation = evaluation_named("segment.double_layer", "accurate");
  ASSERT_TRUE(evaluation.supports<float>());
  EXPECT_FALSE(evaluation.supports<Mp50>());
  for (const auto& [name, make] : segment_regimes()) {
    // Elsewhere float rounds points onto the segment, or leaves its range.
    if (name != "generic" && name != "switch" && name != "far") continue;
    for (int i = 0; i < 40; i += 3) {
      SegmentSample sample = make(i);
      Result<float> found;
      const std::array corners{convert<float>(sample.s[0]), convert<float>(sample.s[1])};
      evaluation(Query<float>{corners, convert<float>(sample.point), 0, {}}, found);
      sample = {{convert<double>(corners[0]), convert<double>(corners[1])},
                convert<double>(convert<float>(sample.point))};
      const auto t = part(integral<DoubleKernel>(sample), 0);
      const auto error = static_cast<double>(norm(difference<Mp100>(t, found.value)) / norm(t));
      EXPECT_LE(error, std::pow(10, -found.stated_digits)) << name << ", sample " << i;
      EXPECT_TRUE(found.converged);
    }
  }
}

// Next to an end of the segment derivatives across it leave the range, and those along it do not: each entry that can
// be held has its own digits. Against the same in 200 digits, in double and rounded to float.
template <class F, Scalar R>
void expect_digits_beside_infinities(const Segment<R>& s, const Vec3<R>& point) {
  const auto found = closed_form<F, 2, R>(s, point);
  const auto truth = closed_form<F, 2, Mp200>({convert<Mp200>(s[0]), convert<Mp200>(s[1])}, convert<Mp200>(point));
  int infinite = 0;
  Mp200 error = 0, size = 0;
  for (int c = 0; c < F::components; ++c)
    for (int i = 0; i < 2; ++i)
      for (int j = 0; j < 2; ++j) {
        const Mp200& expected = truth.hessian[c](i, j);
        const R got = found.hessian[c](i, j);
        if (abs(expected) > Mp200(std::numeric_limits<R>::max())) {
          EXPECT_EQ(got, (expected > 0 ? 1 : -1) * std::numeric_limits<R>::infinity());
          ++infinite;
        } else {
          ASSERT_TRUE(std::isfinite(got));
          error += (Mp200(got) - expected) * (Mp200(got) - expected);
          size += expected * expected;
        }
      }
  EXPECT_GT(infinite, 0);
  EXPECT_LE(static_cast<double>(Mp200(sqrt(Mp200(error / size)))), 64 * static_cast<double>(unit_roundoff<R>()));
}

TEST(segment_accurate, entries_beside_infinite_ones_keep_their_digits) {
  expect_digits_beside_infinities<DoubleLayer, double>({Vec(0, 0, 0), Vec(1, 1, 0)}, {0x1.3p-700, 0, 0});
  using Float = Vec3<float>;
  expect_digits_beside_infinities<DoubleLayer, float>({Float(0, 0, 0), Float(1, 1, 0)}, {0x1.3p-80F, 0, 0});
}

// Entries of an ordinary size beside one of 1e920. The truth is differences of -tan(alpha/2)/r in 4000 digits, by
// mpmath.
TEST(segment_accurate, small_entries_beside_huge_ones_have_digits_of_their_own) {
  const auto found = accurate<MeanValue, 2>({Vec(-0x1.5p-545, 0, 0), Vec(1, 0, 0)}, {0x1.f4p-348, 0x1.8p-1019, 0});
  EXPECT_LE(found.worst(), kAccurateTolerance);
  EXPECT_NEAR(found.jet.hessian[0](0, 0) / -5.9495037191122373906e+111, 1, 1e-15);
  EXPECT_NEAR(found.jet.hessian[1](0, 0) / 6755399.441055744, 1, 1e-15);
  for (const double entry : {found.jet.hessian[0](1, 0), found.jet.hessian[0](1, 1), found.jet.hessian[1](1, 1)})
    EXPECT_EQ(std::abs(entry), std::numeric_limits<double>::infinity());
}

// Zeros beside infinities have no digits of their own, and are found.
TEST(segment_accurate, zeros_beside_infinite_entries_count_from_the_least_normal_number) {
  const double tiny = std::numeric_limits<double>::denorm_min(), parameters[] = {1, .25};
  const auto found = accurate<KelvinDisplacement, 2>({Vec(tiny, 0, 0), Vec(0, 2, 0)}, {0, 0, 0}, parameters);
  EXPECT_LE(found.worst(), kAccurateTolerance);
  int zeros = 0, infinities = 0;
  for (int c = 0; c < KelvinDisplacement::components; ++c)
    for (int i = 0; i < 2; ++i)
      for (int j = 0; j < 2; ++j) {
        zeros += found.jet.hessian[c](i, j) == 0;
        infinities += std::isinf(found.jet.hessian[c](i, j));
      }
  EXPECT_GT(zeros, 0);
  EXPECT_GT(infinities, 0);
}

TEST(segment_accurate, states_no_digits_that_subnormal_numbers_have_not) {
  constexpr std::array<double, 3> exact{}, rounded{0x1p-53, 0, 0};
  Jet<double, 1, 2> jet;
  jet.value[0] = 0x1p-1064;
  jet.gradient[0] = {1, 0x1p-1074};
  EXPECT_EQ(share_of_spacing(jet, exact, 0), 0x1p-10);
  EXPECT_EQ(share_of_spacing(jet, exact, 1), 0x1p-10);
  jet.value[0] = 0x1p-1000;
  EXPECT_EQ(share_of_spacing(jet, exact, 0), 0);
  EXPECT_EQ(share_of_spacing(jet, exact, 1), 0x1p-1074);
  Jet<float, 1, 2> in_float;
  in_float.value[0] = 0x1p-140F;
  EXPECT_EQ(share_of_spacing(in_float, exact, 0), 0x1p-9);
  in_float.value[0] = 0;
  EXPECT_EQ(share_of_spacing(in_float, exact, 0), 0);
  EXPECT_EQ(share_of_spacing(in_float, rounded, 0), 1);
}

}  // namespace
}  // namespace cageproof::closed_form::segment::segment_accurate_test
