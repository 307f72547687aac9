// SPDX-License-Identifier: MIT
// The line form at distances whose squares underflow, and in units whose reciprocals do. So close to a quad, all but a
// part as small as the distance is the integral over its tangent plane, half of it, or a quarter.
#include "cageproof/core/catalogue/evaluation.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace cageproof::adaptive_qmvc {
namespace {

using Vec = Vec3<double>;
using Corners = std::array<Vec, 4>;

template <Scalar R>
Result<R> weights(const Corners& corners, const Vec& point, int order) {
  std::array<Vec3<R>, 4> q;
  for (int k = 0; k < 4; ++k) q[k] = convert<R>(corners[k]);
  Result<R> result;
  (*EvaluationRegister::instance().find("quad.mean_value", "line_form"))(Query<R>{q, convert<R>(point), order, {}},
                                                                         result);
  return result;
}

// How far the value of each corner and the derivatives along the quad's unit normal are from basis[k] times f, f' and
// f'', relative to their norms.
template <Scalar R>
void expect_plane(const Result<R>& found, const std::array<double, 4>& basis, const Vec3<R>& normal, const R& f,
                  const R& slope, const R& bend) {
  EXPECT_TRUE(found.converged);
  for (int k = 0; k < 4; ++k) {
    const R b(basis[k]);
    const Vec3<R> gradient(found.gradient[3 * k], found.gradient[3 * k + 1], found.gradient[3 * k + 2]);
    R second(0);
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) second += normal[i] * found.hessian[9 * k + 3 * i + j] * normal[j];
    EXPECT_LT(std::abs(static_cast<double>(R((found.value[k] - b * f) / f))), 1e-14) << k;
    EXPECT_LT(std::abs(static_cast<double>(R((gradient.dot(normal) - b * slope) / slope))), 1e-14) << k;
    EXPECT_LT(std::abs(static_cast<double>(R((second - b * bend) / bend))), 1e-14) << k;
  }
}

const Corners flat{Vec(0, 0, 0), Vec(1, 0, 0), Vec(1, 1, 0), Vec(0, 1, 0)};
// Planar, through the origin, across all axes; and a saddle that touches z = 0 in its centre.
const Corners tilted{Vec(1, -1, 0), Vec(0, 1, -1), Vec(-1, 1, 0), Vec(0, -1, 1)};
const Corners saddle{Vec(-1, -1, .5), Vec(1, -1, -.5), Vec(1, 1, .5), Vec(-1, 1, -.5)};

class LineFormClose : public testing::TestWithParam<double> {};

TEST_P(LineFormClose, sees_a_plane_next_to_a_face) {
  const Mp50 h(GetParam()), first = pi<Mp50>() / h;
  expect_plane<Mp50>(weights<Mp50>(flat, Vec(.25, .375, GetParam()), 2), {.46875, .15625, .09375, .28125}, {0, 0, 1},
                     -first, first / h, -2 * first / (h * h));
  expect_plane<Mp50>(weights<Mp50>(saddle, Vec(0, 0, GetParam()), 2), {.25, .25, .25, .25}, {0, 0, 1}, -first,
                     first / h, -2 * first / (h * h));
}

TEST_P(LineFormClose, sees_the_right_side_of_a_tilted_face) {
  // The normal is (1, 1, 1): e x b = (-1, 2, -1) x (-1, 0, 1) = (2, 2, 2).
  const Mp50 root = sqrt(Mp50(3)), h = Mp50(GetParam()) / root, first = pi<Mp50>() / h;
  const Vec3<Mp50> normal(1 / root, 1 / root, 1 / root);
  const std::array<double, 4> basis{.25, .25, .25, .25};
  expect_plane<Mp50>(weights<Mp50>(tilted, Vec(GetParam(), 0, 0), 2), basis, normal, -first, first / h,
                     -2 * first / (h * h));
  expect_plane<Mp50>(weights<Mp50>(tilted, Vec(0, -GetParam(), 0), 2), basis, normal, first, first / h,
                     2 * first / (h * h));
}

TEST_P(LineFormClose, sees_a_half_plane_next_to_an_edge_and_a_quarter_at_a_corner) {
  const double d = GetParam();
  const Mp50 h(d), half = pi<Mp50>() / (2 * h);
  for (const double beside : {-3., -1., 0., 1.}) {
    const Mp50 part = 1 + Mp50(beside) / sqrt(Mp50(1 + beside * beside));
    const Result<Mp50> found = weights<Mp50>(flat, Vec(beside * d, .25, d), 0);
    EXPECT_TRUE(found.converged);
    EXPECT_LT(std::abs(static_cast<double>(Mp50(found.value[0] / (-half * part * .75) - 1))), 1e-14) << beside;
    EXPECT_LT(std::abs(static_cast<double>(Mp50(found.value[3] / (-half * part * .25) - 1))), 1e-14) << beside;
  }
  EXPECT_LT(std::abs(static_cast<double>(Mp50(weights<Mp50>(flat, Vec(1, 1, d), 0).value[2] / (-half / 2) - 1))),
            1e-14);
}

TEST_P(LineFormClose, has_the_same_in_double_or_an_infinity_of_its_sign) {
  for (const Corners& corners : {flat, tilted, saddle}) {
    const Vec point(corners == tilted ? 0 : .25, 0, GetParam());
    const Result<Mp50> wide = weights<Mp50>(corners, point, 2);
    const Result<double> found = weights<double>(corners, point, 2);
    for (int o = 0; o <= 2; ++o) {
      Mp50 largest(0);
      for (const Mp50& x : wide.of(o)) largest = std::max(largest, Mp50(abs(x)));
      for (std::size_t i = 0; i < wide.of(o).size(); ++i) {
        const Mp50& exact = wide.of(o)[i];
        const auto rounded = static_cast<double>(exact);
        // An entry below the largest one's rounding has no sign to keep.
        if (abs(exact) < 1e-14 * largest) continue;
        if (std::isinf(rounded)) {
          EXPECT_EQ(found.of(o)[i], rounded) << o << ' ' << i;
        } else {
          EXPECT_LT(static_cast<double>(Mp50(abs(found.of(o)[i] - exact) / largest)), 1e-14) << o << ' ' << i;
        }
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(distances, LineFormClose, testing::Values(1e-20, 1e-149, 1e-200, 5e-324));

TEST(line_form_extreme, scales_to_the_ends_of_the_range) {
  const Vec point(.25, -.5, .75);
  const Result<double> plain = weights<double>(saddle, point, 2);
  for (const int exponent : {-1040, -900, -300, 300, 900, 1020}) {
    const double s = std::ldexp(1., exponent);
    Corners scaled = saddle;
    for (Vec& corner : scaled) corner *= s;
    const Result<double> found = weights<double>(scaled, s * point, 2);
    for (int o = 0; o <= 2; ++o)
      for (std::size_t i = 0; i < plain.of(o).size(); ++i) {
        const double expected = std::ldexp(plain.of(o)[i], -(o + 1) * exponent);
        if (std::isfinite(expected)) {
          EXPECT_NEAR(found.of(o)[i], expected, 1e-14 * std::abs(expected) + 5e-324) << exponent << ' ' << o;
        } else {
          EXPECT_EQ(found.of(o)[i], expected) << exponent << ' ' << o;
        }
      }
  }
}

// A quad as thin as the smallest numbers is next to nothing, but not nothing: N.x / r^4 over its area.
TEST(line_form_extreme, sees_a_quad_of_next_to_no_width) {
  for (const double width : {1e-100, 1e-200, 1e-300}) {
    const Corners thin{Vec(-.5, 0, 0), Vec(.5, 0, 0), Vec(.5, width, 0), Vec(-.5, width, 0)};
    const Result<double> found = weights<double>(thin, Vec(0, 0, 1), 0);
    // int_-.5^.5 dx/(1 + x^2)^2 = atan(.5) + .4, half of it for each end, and half of that for each side.
    const double whole = -width * (std::atan(.5) + .4);
    for (const double w : found.value) EXPECT_NEAR(w, whole / 4, 1e-14 * -whole) << width;
  }
}

}  // namespace
}  // namespace cageproof::adaptive_qmvc
