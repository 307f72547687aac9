// SPDX-License-Identifier: MIT
// Weights where the formula is 0/0.
#include "coordinates/spherical_quad.h"

#include <gtest/gtest.h>

namespace cageproof::adaptive_qmvc {
namespace {

template <class N>
CornerWeights<N> between_opposite_points(int first) {
  // Directions 0 and 180 degrees from the axis' side, the others on one side of their line.
  constexpr std::array<std::array<double, 2>, 4> plane{{{1, 0}, {-1, 0}, {-.6, -.8}, {.6, -.8}}};
  std::array<Vector<N>, 4> directions;
  for (int k = 0; k < 4; ++k) directions[(first + k) % 4] = {N(plane[k][0]), N(plane[k][1]), N(0.)};
  return half_tangents<N>(directions, {N(0.), N(0.), N(1.)});
}

TEST(spherical_quad, gives_the_centre_between_opposite_points_to_these_alone) {
  for (int first = 0; first < 4; ++first) {
    const auto plain = between_opposite_points<double>(first);
    const auto jets = between_opposite_points<SecondOrder<double>>(first);
    for (int k = 0; k < 4; ++k) {
      const double expected = k == first || k == (first + 1) % 4 ? 1 : 0;
      EXPECT_EQ(plain[k], expected) << first << ' ' << k;
      EXPECT_EQ(jets[k].value, expected) << first << ' ' << k;
      EXPECT_TRUE(std::isnan(jets[k].gradient[0])) << "derivatives are not known";
    }
  }
}

}  // namespace
}  // namespace cageproof::adaptive_qmvc
