// SPDX-License-Identifier: MIT
// Mean value coordinates of cages with a small face or slivers beside large faces: inside, next to large faces and to
// their planes, and outside. Hat functions of slivers are as steep as these are thin, which multiplies roundings.
#include "block_errors.h"

#include "cageproof/core/cage/embedded_cages.h"
#include "cageproof/core/geometry/box.h"
#include "cageproof/core/numbers/random_stream.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace cageproof {
namespace {

using namespace block_errors;

// Within the cage's box, about one in eight outside of it.
std::vector<Point> anywhere(const Cage& cage, int count) {
  const auto [low, high] = box_of(cage.vertices());
  std::vector<Point> points;
  points.reserve(count);
  for (int i = 0; i < count; ++i) {
    RandomStream random(17, "anywhere/" + cage.name(), i);
    Point p;
    for (int k = 0; k < 3; ++k) p[k] = low[k] + random.uniform(-0.02, 1.02) * (high[k] - low[k]);
    points.push_back(p);
  }
  return points;
}

// On both sides of faces that have at least a hundredth of the largest one's area, at heights of 1e-6 to 0.3 sizes.
std::vector<Point> next_to_large_faces(const Cage& cage, const CageElements& elements, int count) {
  const auto area_of = [&](std::size_t f) {
    const auto k = elements.corners(f);
    return 0.5 * (k[1] - k[0]).cross(k[2] - k[0]).norm();
  };
  double largest = 0;
  for (std::size_t f = 0; f < elements.count(); ++f) largest = std::max(largest, area_of(f));
  std::vector<Point> points;
  points.reserve(count);
  for (int i = 0; static_cast<int>(points.size()) < count; ++i) {
    RandomStream random(17, "next to faces of " + cage.name(), i);
    const std::size_t f = random.below(static_cast<int>(elements.count()));
    if (area_of(f) < 0.01 * largest) continue;
    const auto k = elements.corners(f);
    double a = random.uniform(), b = random.uniform();
    if (a + b > 1) a = 1 - a, b = 1 - b;
    const double height = 0.3 * cage.size() * std::pow(10., -5.5 * random.uniform());
    points.emplace_back(k[0] + a * (k[1] - k[0]) + b * (k[2] - k[0]) +
                        (i % 2 == 0 ? height : -height) * elements.normals()[f]);
  }
  return points;
}

class SmallFaces : public testing::TestWithParam<const char*> {};

TEST_P(SmallFaces, keep_the_promise_of_mean_values) {
  const Cage cage = embedded_cage(GetParam());
  const CageCoordinates found = coordinates_of(cage, "mean_value", "batched"),
                        reference = coordinates_of(cage, "mean_value", "");
  ASSERT_EQ(found.evaluation(), "batched");
  std::vector<Point> points = anywhere(cage, 16);
  for (const Point& p : next_to_large_faces(cage, found.elements(), 24)) points.push_back(p);
  // Each order is computed in its own way.
  for (const Point& p : points) {
    const auto truth = block_truth(reference, p, 2, OfHessians::WithSlope);
    for (const int order : {0, 1, 2})
      EXPECT_LE(block_error(found, truth, cage.size(), p, order), 64) << "order " << order << " at " << p.transpose();
  }
}

INSTANTIATE_TEST_SUITE_P(of_cages, SmallFaces,
                         testing::Values("needles-1e-2", "needles-1e-5", "needles-1e-8", "bevel-1e-5", "bevel-1e-8",
                                         "pinch-1e-5", "pinch-1e-8", "bump-1e-2", "bump-1e-5", "bump-1e-8", "graded"));

}  // namespace
}  // namespace cageproof
