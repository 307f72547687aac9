// SPDX-License-Identifier: MIT
// Points and triangles whose distances, squared, leave double's range: held to laws that ordinary points obey too.
#include "cageproof/closed_form/triangle/biharmonic_double_layer.h"
#include "cageproof/closed_form/triangle/double_layer.h"
#include "cageproof/closed_form/triangle/engine/closed_form.h"
#include "cageproof/closed_form/triangle/mean_value.h"
#include "cageproof/closed_form/triangle/single_layer.h"
#include "cageproof/closed_form/triangle/solid_angle.h"
#include "cageproof/core/catalogue/evaluation.h"

#include <gtest/gtest.h>

#include <numbers>

namespace cageproof::closed_form::triangle {
namespace {

using Vec = Vec3<double>;
using Corners = Triangle<double>;

constexpr double pi_d = std::numbers::pi;
const Corners flat{Vec(0, 0, 0), Vec(1, 0, 0), Vec(0, 1, 0)};
const Corners tilted{Vec(1, -1, 0), Vec(0, 1, -1), Vec(-1, 0, 1)};

template <class F>
Jet<double, F::components> at(const Corners& t, const Vec& p) {
  return closed_form<F, 2, double>(t, p, {});
}

// f(s T, s p) = s^(degree - order) f(T, p), of which a power of two s is exact.
template <class F>
void expect_scaling(const Corners& t, const Vec& p, int exponent) {
  const double s = std::ldexp(1., exponent);
  const auto plain = at<F>(t, p), scaled = at<F>({Vec(s * t[0]), Vec(s * t[1]), Vec(s * t[2])}, s * p);
  const auto back = [&](double x, int order) { return std::ldexp(x, exponent * (order - F::degree)); };
  for (int c = 0; c < F::components; ++c) {
    EXPECT_NEAR(back(scaled.value[c], 0), plain.value[c], 1e-14 * std::abs(plain.value[c]));
    for (int i = 0; i < 3; ++i)
      EXPECT_NEAR(back(scaled.gradient[c][i], 1), plain.gradient[c][i], 1e-14 * plain.gradient[c].norm());
    for (int i = 0; i < 9; ++i)
      EXPECT_NEAR(back(scaled.hessian[c](i), 2), plain.hessian[c](i), 1e-13 * plain.hessian[c].norm());
  }
}

TEST(extreme, whole_inputs_scale) {
  for (const int exponent : {-500, -300, 300, 500})
    for (const Corners& t : {flat, tilted}) {
      const Vec p(.3, .2, -.45);
      expect_scaling<SingleLayer>(t, p, exponent);
      expect_scaling<DoubleLayer>(t, p, exponent);
      expect_scaling<BiharmonicDoubleLayer>(t, p, exponent);
    }
}

TEST(extreme, sides_of_a_tilted_face_are_told_apart) {
  for (const double d : {1e-100, 1e-250, 5e-324}) {
    EXPECT_DOUBLE_EQ(at<SolidAngle>(tilted, Vec(d, 0, 0)).value[0], -2 * pi_d) << d;
    EXPECT_DOUBLE_EQ(at<SolidAngle>(tilted, Vec(-d, 0, 0)).value[0], 2 * pi_d) << d;
  }
}

TEST(extreme, next_to_an_edge_the_solid_angle_is_a_half_planes) {
  // That of a half plane is twice the angle to it, whose gradient is 2/distance.
  for (const double d : {1e-20, 1e-100, 1e-165, 1e-300}) {
    const auto outside = at<SolidAngle>(flat, Vec(.25, -d, 0)), above = at<SolidAngle>(flat, Vec(.25, 0, d));
    EXPECT_EQ(outside.value[0], 0) << d;
    EXPECT_DOUBLE_EQ(std::abs(outside.gradient[0][2]) * d, 2) << d;
    EXPECT_DOUBLE_EQ(above.value[0], -pi_d) << d;
    EXPECT_DOUBLE_EQ(std::abs(above.gradient[0][1]) * d, 2) << d;
  }
}

TEST(extreme, far_away_a_triangle_is_its_area) {
  for (const double r : {1e84, 1e150, 1e300}) {
    EXPECT_NEAR(at<SingleLayer>(flat, Vec(0, 0, r)).value[0] * r, 1 / (8 * pi_d), 1e-16) << r;
    // With x.n/r^3 = -1/r^2, a sixth of the area each; 1e-600 is no number of double's.
    const double layer = at<DoubleLayer>(flat, Vec(0, 0, r)).value[0];
    if (r < 1e153) EXPECT_NEAR(layer * r * r, -1 / (24 * pi_d), 1e-16) << r;
    else EXPECT_EQ(layer, 0) << r;
  }
}

// One of its entries is beyond double's range; the truths of the others are mpmath's, in 2500 digits.
TEST(extreme, entries_beside_an_infinite_one_keep_their_digits) {
  const auto omega = at<SolidAngle>({Vec(0, 0, 0), Vec(4, 0, 0), Vec(-1, -3, -2)}, Vec(1, 0, -0x1.8p-753));
  const auto& hessian = omega.hessian[0];
  EXPECT_EQ(hessian(1, 2), std::numeric_limits<double>::infinity());
  EXPECT_DOUBLE_EQ(hessian(0, 1), -0.22502547015503065016);
  EXPECT_DOUBLE_EQ(hessian(0, 2), 0.33753820523254597523);
  EXPECT_DOUBLE_EQ(hessian(1, 1), -0.74279516764712694698);
  EXPECT_DOUBLE_EQ(hessian(2, 2), 0.74279516764712694698);
}

// A third of the area times what the kernel x.n/(4 pi r^3) has at the corner.
TEST(extreme, from_afar_a_tiny_triangle_has_the_kernels_hessian) {
  const Vec p(0.5, 0.25, 1);
  const double r2 = p.squaredNorm(), r5 = r2 * r2 * std::sqrt(r2);
  for (const double s : {1e-60, 1e-130, 1e-140, 1e-150}) {
    const auto layer = at<DoubleLayer>({Vec(0, 0, 0), Vec(s, 0, 0), Vec(0, s, 0)}, p);
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) {
        const double by_z = (i == 2 ? p[j] : 0) + (j == 2 ? p[i] : 0) + (i == j ? p[2] : 0);
        const double kernel = (3 * by_z - 15 * p[2] * p[i] * p[j] / r2) / (4 * pi_d * r5);
        for (int k = 0; k < 3; ++k) EXPECT_NEAR(layer.hessian[k](i, j), s * s / 6 * kernel, 1e-13 * s * s) << s;
      }
  }
  // Numbers smaller than any of double's are zero.
  for (const double s : {1e-170, 1e-310, 5e-324})
    EXPECT_EQ(at<DoubleLayer>({Vec(0, 0, 0), Vec(s, 0, 0), Vec(0, s, 0)}, p).hessian[0].norm(), 0) << s;
}

TEST(extreme, mean_value_weights_next_to_the_plane_are_linear_in_the_height) {
  // Beside the triangle, also on an edge's line, an odd function of the height.
  for (const Vec& foot : {Vec(-.5, .25, 0), Vec(-.5, 0, 0), Vec(.3, -.4, 0)})
    for (const double d : {1e-40, 1e-120, 1e-250}) {
      const auto tiny = at<MeanValue>(flat, foot + Vec(0, 0, d)), small = at<MeanValue>(flat, foot + Vec(0, 0, 1e-9));
      for (int k = 0; k < 3; ++k) {
        EXPECT_NEAR(tiny.value[k] / d, small.value[k] / 1e-9, 1e-13 * std::abs(small.value[k] / 1e-9)) << d;
        EXPECT_NEAR(tiny.gradient[k][2], small.gradient[k][2], 1e-13 * small.gradient[k].norm()) << d;
        EXPECT_NEAR(tiny.hessian[k](0, 2), small.hessian[k](0, 2), 1e-13 * small.hessian[k].norm()) << d;
      }
    }
}

// Some 1e-324, less than half of the least number, is zero: of that no digit is right.
TEST(extreme, accurate_states_no_digits_of_what_became_zero) {
  const std::vector<Vec> corners{{0, 0, 0}, {1, 0, 0}, {0.3, 5e-324, 0}};
  for (const char* formula : {"triangle.double_layer", "triangle.biharmonic_double_layer"}) {
    Result<double> layer;
    evaluation_named(formula, "accurate")(Query<double>{corners, Vec(0.4, 0.25, 0.5)}, layer);
    EXPECT_EQ(layer.value[0], 0) << formula;
    EXPECT_FALSE(layer.stated_digits > 0) << formula;
  }
}

TEST(extreme, accurate_states_no_digits_that_two_hundred_do_not_hold) {
  // Over the centre of an equilateral triangle the Hessian is a zero's, linear in the distance.
  const auto over_height = [](const BoundedJet<double, 1>& f, int exponent) {
    return Eigen::Matrix3d(f.jet.hessian[0].unaryExpr([&](double x) { return std::ldexp(x, -exponent); }));
  };
  const auto at_height = [](int exponent) {
    return accurate<SolidAngle, 2>(tilted, Vec(std::ldexp(1., exponent), 0, 0), {});
  };
  const Eigen::Matrix3d expected = over_height(at_height(-60), -60);
  int stated = 0;
  for (const int exponent : {-100, -300, -800}) {
    const auto found = at_height(exponent);
    EXPECT_DOUBLE_EQ(found.jet.value[0], -2 * pi_d);
    if (found.bound[2] == 1) continue;
    ++stated;
    EXPECT_LT((over_height(found, exponent) - expected).norm(), 1e-14 * expected.norm()) << exponent;
  }
  EXPECT_EQ(stated, 3);
}

}  // namespace
}  // namespace cageproof::closed_form::triangle
