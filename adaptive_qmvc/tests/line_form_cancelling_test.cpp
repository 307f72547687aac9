// SPDX-License-Identifier: MIT
// The line form where sheets of a quad that folds over or crosses itself cancel next to the point.
#include "line_form_fold_truths.h"

#include "cageproof/core/catalogue/evaluation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace cageproof::adaptive_qmvc {
namespace {

using Corners = std::array<Vec3<double>, 4>;

template <Scalar R>
Result<R> weights(const Corners& corners, const Vec3<double>& point, std::string_view name, int order) {
  std::array<Vec3<R>, 4> q;
  for (int k = 0; k < 4; ++k) q[k] = convert<R>(corners[k]);
  Result<R> result;
  (*EvaluationRegister::instance().find("quad.mean_value", name))(Query<R>{q, convert<R>(point), order, {}}, result);
  return result;
}

template <Scalar R>
Result<R> weights(const LineFormTruth& c, std::string_view name, int order) {
  Corners corners;
  for (int k = 0; k < 4; ++k) corners[k] = {c.corners[k][0], c.corners[k][1], c.corners[k][2]};
  return weights<R>(corners, Vec3<double>(c.point[0], c.point[1], c.point[2]), name, order);
}

// In units of 2^-53 of the norm; infinite where not all are zero that must be.
template <Scalar R>
double error(const Result<R>& result, const LineFormTruth& c, int order) {
  const std::vector<R>& found = result.of(order);
  const std::span<const double> exact = order == 0   ? std::span<const double>(c.value)
                                        : order == 1 ? std::span<const double>(c.gradient)
                                                     : std::span<const double>(c.hessian);
  double norm = 0, difference = 0;
  for (const double x : exact) norm = std::hypot(norm, x);
  for (std::size_t i = 0; i < exact.size(); ++i)
    if (found[i] != R(exact[i]))
      difference = std::hypot(difference, static_cast<double>(R(found[i] - R(exact[i]))) / norm);
  return std::isfinite(difference) ? difference / 0x1p-53 : HUGE_VAL;
}

class LineFormCancelling : public testing::TestWithParam<std::size_t> {
 protected:
  const LineFormTruth& c() const { return line_form_fold_truths()[GetParam()]; }
};

TEST_P(LineFormCancelling, is_the_integral_at_every_order) {
  for (int asked = 0; asked <= 2; ++asked) {
    const Result<double> found = weights<double>(c(), "line_form", asked);
    EXPECT_TRUE(found.converged);
    for (int o = 0; o <= asked; ++o) EXPECT_LT(error(found, c(), o), 64) << asked << ' ' << o;
  }
}

TEST_P(LineFormCancelling, is_the_integral_in_more_digits) {
  const Result<Mp100> found = weights<Mp100>(c(), "line_form", 2);
  for (int o = 0; o <= 2; ++o) EXPECT_LT(error(found, c(), o), 2) << o;
}

TEST_P(LineFormCancelling, gives_the_digits_that_its_name_says) {
  for (const auto& [name, digits] : {std::pair{"line-8", 8}, std::pair{"line-12", 12}}) {
    const Result<double> found = weights<double>(c(), name, 2);
    for (int o = 0; o <= 2; ++o) EXPECT_LT(error(found, c(), o), std::pow(10.0, -digits) / 0x1p-53 + 64) << name << o;
  }
}

std::string place_of(const testing::TestParamInfo<std::size_t>& place) {
  return std::string(line_form_fold_truths()[place.param].name);
}

INSTANTIATE_TEST_SUITE_P(folds, LineFormCancelling, testing::Range<std::size_t>(0, line_form_fold_truths().size()),
                         place_of);

// Two corners in one, and the others mirrored: the same surface from both sides, whose first and third weight are
// nothing and whose others are opposite. Nothing about the mirror is used but the definition.
TEST(line_form, is_as_symmetric_as_a_fold) {
  const Corners fold{Vec3<double>(-1, 0, 1), Vec3<double>(-1, 0, 0), Vec3<double>(0, 0, 0), Vec3<double>(-1, 0, 0)};
  for (int k = 1; k <= 52; ++k) {
    const double h = std::ldexp(1., -k);
    const Result<double> found = weights<double>(fold, h * Vec3<double>(-1, .75, .5), "line_form", 2);
    for (int o = 0; o <= 2; ++o) {
      const std::vector<double>& tensor = found.of(o);
      const std::size_t block = tensor.size() / 4;
      double norm = 0, rest = 0;
      for (const double x : tensor) norm = std::hypot(norm, x);
      for (std::size_t i = 0; i < block; ++i) {
        rest = std::max({rest, std::abs(tensor[i]), std::abs(tensor[2 * block + i]),
                         std::abs(tensor[block + i] + tensor[3 * block + i])});
      }
      EXPECT_LE(rest, 64 * 0x1p-53 * norm) << "distance 2^-" << k << ", order " << o;
    }
  }
}

// All lines across a crossing pass it: the weights are no basis functions there, but jump from one side to the other.
TEST(line_form, jumps_at_a_crossing) {
  const Corners crossed{Vec3<double>(0, 0, 0), Vec3<double>(0, 1, 1), Vec3<double>(0, 1, 0), Vec3<double>(0, 0, 1)};
  // xi - eta = (-h, t, s t) with t = u - 1/2 and s = 1 - 2v, and N.x = 2 h t: along t, int 2 h t^2/r^4 leaves
  // pi/(1 + s^2)^(3/2) of each basis function's slope, whose mean over v is this.
  const double limit = std::numbers::pi / (2 * std::numbers::sqrt2);
  for (const int k : {60, 200, 400, 1000}) {
    const Result<double> found = weights<double>(crossed, Vec3<double>(std::ldexp(1., -k), .5, .5), "line_form", 0);
    for (int i = 0; i < 4; ++i)
      EXPECT_NEAR(found.value[i], i == 0 || i == 3 ? -limit : limit, 64 * 0x1p-53) << "distance 2^-" << k << ' ' << i;
  }
}

// A point under a saddle's corner in the plane of its sides: its distance is the product of its parameters, and the
// line next to it is far narrower a singularity than the side, which no rounding may hide.
TEST(line_form, sees_a_face_next_to_its_corner) {
  const Corners saddle{Vec3<double>(0, 0, 0), Vec3<double>(0, 1, -1), Vec3<double>(1, 2, 1), Vec3<double>(0, 1, 1)};
  const Vec3<double> point(0, 0x1p-54, -0x1.8p-57);
  // Up to terms that rounding loses, y = u + v and z = v - u, and the surface is x = u v over the point.
  const double u = (point[1] - point[2]) / 2, v = (point[1] + point[2]) / 2;
  const Result<double> found = weights<double>(saddle, point, "line_form", 0);
  EXPECT_TRUE(found.converged);
  EXPECT_NEAR(std::abs(found.value[0]), std::numbers::pi / (u * v), 1e-14 * std::numbers::pi / (u * v));
}

}  // namespace
}  // namespace cageproof::adaptive_qmvc
