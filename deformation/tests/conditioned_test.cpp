// SPDX-License-Identifier: MIT
// Cages whose elements are stout, and whose systems lose digits all the same.
#include "settings.h"

#include <gtest/gtest.h>

namespace cageproof::deformation::test {
namespace {

// Two pyramids, base to base, so flat that their tips nearly meet. No triangle of it is thin.
Cage flat_octahedron(double half_height) {
  std::vector<Vec> vertices{{2, 0, 0}, {-2, 0, 0}, {0, half_height, 0}, {0, -half_height, 0}, {0, 0, 2}, {0, 0, -2}};
  return Cage::make("octahedron", std::move(vertices),
                    {{{0, 2, 4, -1}},
                     {{2, 1, 4, -1}},
                     {{1, 3, 4, -1}},
                     {{3, 0, 4, -1}},
                     {{2, 0, 5, -1}},
                     {{1, 2, 5, -1}},
                     {{3, 1, 5, -1}},
                     {{0, 3, 5, -1}}},
                    {});
}

// Over the second derivatives' norm.
double error_of_hessians(const CageCoordinates& coordinates, const Vec& point) {
  const auto found = coordinates.at<double>(point, 2);
  const auto exact = coordinates.at<Mp50>(convert<Mp50>(point), 2);
  double error = 0, size = 0;
  for (std::size_t i = 0; i < found[0].of(2).size(); ++i) {
    error = std::hypot(error, static_cast<double>(Mp50(Mp50(found[0].of(2)[i]) - exact[0].of(2)[i])));
    size = std::hypot(size, found[0].of(2)[i]);
  }
  return error / size;
}

// The two systems' conditions, 1.8e3 and 3.0e3, multiply.
TEST(conditioned, systems_are_solved_in_more_digits) {
  const Vec point(0.12863145221431438, -0.0015565431084010293, -0.078626909640513);
  for (const double half_height : {2e-2, 2e-3, 2e-4}) {
    const CageCoordinates c(flat_octahedron(half_height), coordinate_kind_named("regularised_weber"),
                            CoordinateOptions{});
    double condition = 1;
    for (const SolvedSystem& system : c.solved()) condition *= system.condition;
    EXPECT_EQ(condition > 1e6, half_height < 1e-2) << condition;
    // Below that condition double leaves roundings times it.
    EXPECT_LT(error_of_hessians(c, {point[0], point[1] * half_height / 2e-3, point[2]}),
              condition > 1e6 ? 1e-11 : 1e-10)
        << half_height;
  }
}

}  // namespace
}  // namespace cageproof::deformation::test
