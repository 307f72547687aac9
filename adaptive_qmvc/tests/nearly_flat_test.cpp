// SPDX-License-Identifier: MIT
// Quads that are all but flat, from points on their borders: integrals of N.x are as small as the twist, and
// proportional to it.
#include "cageproof/core/catalogue/evaluation.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace cageproof {
namespace {

std::vector<double> values_over_twist(double twist, const Vec3<double>& point) {
  const std::array<Vec3<double>, 4> corners{Vec3<double>(0, 0, 0), {1, 0, 0}, {1, 1, twist}, {0, 1, 0}};
  Result<double> result;
  evaluation_named("quad.biharmonic_double_layer", "line_form")(Query<double>{corners, point, 0}, result);
  std::vector<double> found;
  found.reserve(result.value.size());
  for (const double value : result.value) found.push_back(value / twist);
  return found;
}

TEST(NearlyFlat, integrals_on_the_border_are_proportional_to_the_twist) {
  const auto places = [](double twist) {
    return std::array<Vec3<double>, 4>{Vec3<double>(1, 1, twist), {0, 0, 0}, {0.5, 1, twist / 2}, {0.25, 0, 0}};
  };
  // The next term is as large as the twist squared.
  constexpr double reference = 0x1p-27;
  for (int k = 0; k < 4; ++k) {
    const std::vector<double> expected = values_over_twist(reference, places(reference)[k]);
    double largest = 0;
    for (const double value : expected) largest = std::max(largest, std::abs(value));
    ASSERT_GT(largest, 1e-4);
    for (const int bits : {34, 40, 47, 52}) {
      const double twist = std::ldexp(1, -bits);
      const std::vector<double> found = values_over_twist(twist, places(twist)[k]);
      for (std::size_t i = 0; i < found.size(); ++i)
        EXPECT_NEAR(found[i], expected[i], 1e-13 * largest)
            << "place " << k << ", twist 2^-" << bits << ", corner " << i;
    }
  }
}

}  // namespace
}  // namespace cageproof
