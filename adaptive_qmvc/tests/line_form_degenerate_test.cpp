// SPDX-License-Identifier: MIT
// The line form next to a corner whose sides lie on one line, where the quad's normal vanishes, and on thin quads that
// are no rectangles.
#include "line_form_truths.h"

#include "cageproof/core/catalogue/evaluation.h"

#include <gtest/gtest.h>

#include <cmath>

namespace cageproof::adaptive_qmvc::line_form_degenerate_test {
namespace {

template <Scalar R>
Result<R> evaluate(const LineFormTruth& c, std::string_view name, int order) {
  std::vector<Vec3<R>> q;
  q.reserve(c.corners.size());
  for (const auto& corner : c.corners) q.push_back(convert<R>(Vec3<double>(corner[0], corner[1], corner[2])));
  const Vec3<R> point = convert<R>(Vec3<double>(c.point[0], c.point[1], c.point[2]));
  Result<R> result;
  (*EvaluationRegister::instance().find("quad.mean_value", name))(Query<R>{q, point, order, {}}, result);
  return result;
}

std::span<const double> truth(const LineFormTruth& c, int order) {
  if (order == 0) return c.value;
  if (order == 1) return c.gradient;
  return c.hessian;
}

template <Scalar R>
double relative_error(const std::vector<R>& found, std::span<const double> exact) {
  double size = 0;
  for (const double x : exact) size = std::hypot(size, x);
  double error = 0;
  for (std::size_t i = 0; i < exact.size(); ++i)
    error = std::hypot(error, static_cast<double>(R(found[i] - R(exact[i]))) / size);
  return error;
}

// No case is so ill-conditioned that its plain error needs more.
constexpr double kUnit = 0x1p-53;

class LineFormNear : public testing::TestWithParam<std::size_t> {
 protected:
  const LineFormTruth& c() const { return line_form_truths()[GetParam()]; }
};

TEST_P(LineFormNear, is_the_integral_at_every_order) {
  SCOPED_TRACE(c().name);
  for (int asked = 0; asked <= 2; ++asked) {
    const Result<double> found = evaluate<double>(c(), "line_form", asked);
    EXPECT_TRUE(found.converged);
    for (int o = 0; o <= asked; ++o)
      EXPECT_LT(relative_error(found.of(o), truth(c(), o)), 64 * kUnit) << asked << ' ' << o;
  }
}

TEST_P(LineFormNear, is_the_integral_in_more_digits) {
  SCOPED_TRACE(c().name);
  const Result<Mp50> in_50 = evaluate<Mp50>(c(), "line_form", 2);
  const Result<Mp100> in_100 = evaluate<Mp100>(c(), "line_form", 2);
  for (int o = 0; o <= 2; ++o) {
    EXPECT_LT(relative_error(in_50.of(o), truth(c(), o)), 2 * kUnit) << o;
    EXPECT_LT(relative_error(in_100.of(o), truth(c(), o)), 2 * kUnit) << o;
  }
}

TEST_P(LineFormNear, gives_the_digits_that_its_name_says) {
  SCOPED_TRACE(c().name);
  for (const auto& [name, digits] : {std::pair{"line-4", 4}, std::pair{"line-8", 8}, std::pair{"line-12", 12}}) {
    const Result<double> found = evaluate<double>(c(), name, 2);
    for (int o = 0; o <= 2; ++o)
      EXPECT_LT(relative_error(found.of(o), truth(c(), o)), std::pow(10.0, -digits) + 64 * kUnit) << name << ' ' << o;
  }
}

std::string place_of(const testing::TestParamInfo<std::size_t>& place) {
  return std::string(line_form_truths()[place.param].name);
}

INSTANTIATE_TEST_SUITE_P(degenerate, LineFormNear, testing::Range<std::size_t>(0, line_form_truths().size()), place_of);

}  // namespace
}  // namespace cageproof::adaptive_qmvc::line_form_degenerate_test
