// SPDX-License-Identifier: MIT
// Mean value coordinates of whole cages where their integrals would cancel: next to planes of faces beside these, and
// to lines of edges beyond their ends. Truth in 100 digits, by the judge's own units.
#include "cageproof/validation/block_error.h"

#include "cageproof/core/embedded_cages.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

namespace cageproof::validation {
namespace {

// (1 - a - b, a, b) of each face's corners, moved along its normal by some heights.
void expect_kept(double a, double b, std::size_t least) {
  const Cage cage = embedded_cage("l-block");
  const CoordinateKind& kind = coordinate_kind_named("mean_value");
  const CageCoordinates coordinates(cage, kind, CoordinateOptions{.evaluation = "batched"});
  const BlockTruths truths(cage, kind, Triangulation::Shortest);
  const CageElements& elements = coordinates.elements();
  std::size_t asked = 0;
  for (std::size_t f = 0; f < elements.count(); ++f)
    for (const double height : {0., 1e-15, 1e-12, 1e-9, 1e-6, 1e-4, 2.1e-3, 4e-3, 0.01, 0.03, 0.1, 0.3}) {
      const auto k = elements.corners(f);
      const Vec3<double> point = k[0] + a * (k[1] - k[0]) + b * (k[2] - k[0]) + height * elements.normals()[f];
      if (!elements.touching(point).empty()) continue;
      const auto truth = truths.at(point, 2);
      ASSERT_TRUE(truth);
      const auto errors = block_errors(coordinates.at<double>(point, 2), *truth);
      const std::array<double, 3> bounds{64, 16, 16};
      for (int o = 0; o < 3; ++o)
        EXPECT_LE(errors[o].roundings, bounds[o]) << "order " << o << ", " << height << " at " << point.transpose();
      ++asked;
    }
  EXPECT_GE(asked, least);
}

TEST(BatchedMeanValues, next_to_planes_of_faces) { expect_kept(1.375, 0.8125, 120); }
TEST(BatchedMeanValues, near_the_border_in_planes_of_faces) { expect_kept(1.015625, 0.25, 120); }
TEST(BatchedMeanValues, beyond_ends_of_edges) { expect_kept(1.375, 0, 120); }
TEST(BatchedMeanValues, within_faces_near_their_border) { expect_kept(0.5, 0.015625, 120); }

}  // namespace
}  // namespace cageproof::validation
