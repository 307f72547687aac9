// SPDX-License-Identifier: MIT
#include "geometry/meeting_boxes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <utility>

namespace cageproof {
namespace {

using Pairs = std::vector<std::pair<int, int>>;

Pairs pairs_of(const std::vector<Eigen::AlignedBox3d>& boxes) {
  Pairs found;
  for_meeting_boxes(boxes, [&](int a, int b) {
    found.emplace_back(a, b);
    return true;
  });
  return found;
}

TEST(MeetingBoxes, ends_where_it_is_told_to) {
  const std::vector<Eigen::AlignedBox3d> equal(4,
                                               Eigen::AlignedBox3d(Eigen::Vector3d::Zero(), Eigen::Vector3d::Ones()));
  int calls = 0;
  for_meeting_boxes(equal, [&](int, int) { return ++calls < 2; });
  EXPECT_EQ(calls, 2);
}

TEST(MeetingBoxes, one_by_one_and_in_order) {
  // Corners on a coarse grid, so that many boxes touch, are flat, or the same.
  std::mt19937_64 random(7);
  const auto coordinate = [&] { return 0.25 * static_cast<double>(random() % 16); };
  std::vector<Eigen::AlignedBox3d> boxes(300);
  for (auto& box : boxes) {
    const Eigen::Vector3d low(coordinate(), coordinate(), coordinate());
    box = Eigen::AlignedBox3d(low, low + 0.2 * Eigen::Vector3d(coordinate(), coordinate(), coordinate()));
  }
  Pairs all;
  for (int a = 0; a < 300; ++a)
    for (int b = a + 1; b < 300; ++b)
      if (boxes[a].intersects(boxes[b])) all.emplace_back(a, b);
  ASSERT_GT(all.size(), 300u);
  EXPECT_EQ(pairs_of(boxes), all);
}

TEST(MeetingBoxes, touching_in_a_corner_and_one_ulp_apart) {
  const Eigen::Vector3d zero(0, 0, 0), one(1, 1, 1), beyond(1, 1, std::nextafter(1.0, 2.0)), two(2, 2, 2);
  EXPECT_EQ(pairs_of({{zero, one}, {one, two}}), (Pairs{{0, 1}}));
  EXPECT_EQ(pairs_of({{zero, one}, {beyond, two}}), Pairs());
}

TEST(MeetingBoxes, of_extreme_size) {
  const Eigen::Vector3d largest(1e308, 1e308, 1e308), least(5e-324, 5e-324, 5e-324), zero(0, 0, 0);
  EXPECT_EQ(pairs_of({{-largest, largest}, {zero, least}, {least, least}, {-least, zero}}),
            (Pairs{{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}}));
}

TEST(MeetingBoxes, none_and_one) {
  EXPECT_EQ(pairs_of({}), Pairs());
  EXPECT_EQ(pairs_of({{Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(1, 1, 1)}}), Pairs());
}

}  // namespace
}  // namespace cageproof
