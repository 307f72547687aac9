// SPDX-License-Identifier: MIT
// The integral over a twisted quad a million sizes away, where both sums that are compared once took the same nodes,
// too few of them, and agreed to six digits more than they had.
#include "cageproof/core/catalogue/evaluation.h"

#include <gtest/gtest.h>

namespace cageproof::quadrature_ref {
namespace {

TEST(FarQuad, has_the_digits_that_it_states) {
  const std::array<Vec3<Mp50>, 4> corners{Vec3<Mp50>(0, 0, 0), Vec3<Mp50>(1, 0, 0), Vec3<Mp50>(1, 1, Mp50(0.5)),
                                          Vec3<Mp50>(0, 1, 0)};
  const Vec3<Mp50> point(Mp50(1000000.5), Mp50(-999999.625), Mp50(999999.5));
  // By the line form, which is algebra along lines, to 80 digits.
  const std::array<const char*, 4> expected{"-3.8286724860527580350154465395570369290262493952946766e-15",
                                            "-4.4667866010449044794196249185458073557475519151831173e-15",
                                            "-3.8286732039286414508056503400402671753700339113018145e-15",
                                            "-3.1905590889375097826708252966640686341112381672662612e-15"};
  Result<Mp50> result;
  evaluation_named("quad.double_layer", "multiprecision")({.corners = corners, .point = point}, result);
  ASSERT_EQ(result.value.size(), 4U);
  Mp50 square(0), size(0);
  for (std::size_t k = 0; k < 4; ++k) {
    const Mp50 truth(expected[k]), difference = result.value[k] - truth;
    square += difference * difference;
    size += truth * truth;
  }
  EXPECT_GE(result.stated_digits, 30);
  EXPECT_LT(static_cast<double>(Mp50(log10(Mp50(square / size)) / 2)), -result.stated_digits);
}

}  // namespace
}  // namespace cageproof::quadrature_ref
