// SPDX-License-Identifier: MIT
#include "cageproof/core/numbers/second_order.h"

#include <gtest/gtest.h>

namespace cageproof {
namespace {

using Number = SecondOrder<double>;

// x y + x/z - sqrt(z) composed with everything that SecondOrder has, against derivatives by hand.
TEST(second_order, differentiates_arithmetic) {
  const double x = 1.5, y = -0.75, z = 2.25;
  const Number X = Number::variable(x, 0), Y = Number::variable(y, 1), Z = Number::variable(z, 2);
  const Number f = X * Y + X / Z - sqrt(Z) + Number(3.0) - -Y;
  EXPECT_EQ(f.value, x * y + x / z - std::sqrt(z) + 3.0 + y);
  EXPECT_DOUBLE_EQ(f.gradient[0], y + 1 / z);
  EXPECT_DOUBLE_EQ(f.gradient[1], x + 1);
  EXPECT_DOUBLE_EQ(f.gradient[2], -x / (z * z) - 0.5 / std::sqrt(z));
  const std::array<double, 6> hessian{0, 1, -1 / (z * z), 0, 0, 2 * x / (z * z * z) + 0.25 / (z * std::sqrt(z))};
  for (std::size_t k = 0; k < 6; ++k) EXPECT_NEAR(f.hessian[k], hessian[k], 1e-15) << k;
}

// exp(x + y^2) and u^2 v as outer functions.
TEST(second_order, composes) {
  const Number X = Number::variable(0.5, 0), Y = Number::variable(0.25, 1);
  const Number inner = X + Y * Y;
  const double e = std::exp(inner.value);
  const Number f = composed(e, e, e, inner);
  EXPECT_DOUBLE_EQ(f.gradient[1], 0.5 * e);
  EXPECT_DOUBLE_EQ(f.hessian[Number::entry(0, 1)], 0.5 * e);
  EXPECT_DOUBLE_EQ(f.hessian[Number::entry(1, 1)], (2 + 0.25) * e);
  const Number u = X * Y, v = X + Y;  // u^2 v = x^3 y^2 + x^2 y^3
  const Partials<double> p{
      u.value * u.value * v.value, 2 * u.value * v.value, u.value * u.value, 2 * v.value, 2 * u.value, 0};
  const Number g = composed(p, u, v);
  const double x = 0.5, y = 0.25;
  EXPECT_DOUBLE_EQ(g.gradient[0], 3 * x * x * y * y + 2 * x * y * y * y);
  EXPECT_DOUBLE_EQ(g.hessian[Number::entry(0, 1)], 6 * x * x * y + 6 * x * y * y);
  EXPECT_DOUBLE_EQ(g.hessian[Number::entry(1, 1)], 2 * x * x * x + 6 * x * x * y);
}

}  // namespace
}  // namespace cageproof
