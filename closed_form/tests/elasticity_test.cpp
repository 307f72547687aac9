// SPDX-License-Identifier: MIT
// The constants of [T24] Eq 48, as the paper means them and as it prints b.
#include "published/triangle/engine/elasticity.h"

#include <gtest/gtest.h>

namespace cageproof::closed_form::published::elasticity_test {
namespace {

TEST(elasticity, constants_after_the_errata_and_as_printed) {
  for (const double mu : {1., 2.5})
    for (const double nu : {-1., 0., .25, .45}) {
      const Elasticity<double> meant(mu, nu, Misprint::None), printed(mu, nu, Misprint::Equation48);
      const double a = 1 / (4 * pi<double>() * mu);
      EXPECT_DOUBLE_EQ(meant.mu, mu);
      EXPECT_DOUBLE_EQ(meant.a, a);
      EXPECT_DOUBLE_EQ(meant.b, a / (4 * (1 - nu)));
      EXPECT_DOUBLE_EQ(printed.a, a);
      EXPECT_DOUBLE_EQ(printed.b, a / 4 * (1 - nu)) << "a/4(1 - nu), from left to right";
    }
}

}  // namespace
}  // namespace cageproof::closed_form::published::elasticity_test
