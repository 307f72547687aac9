// SPDX-License-Identifier: MIT
#include "cageproof/core/geometry/box_tree.h"

#include "cageproof/core/numbers/random_stream.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

namespace cageproof {
namespace {

std::vector<Box> random_boxes(int count, double unit) {
  std::vector<Box> boxes;
  for (int i = 0; i < count; ++i) {
    RandomStream random(5, "boxes", i);
    const Vec3<double> corner(random.uniform(), random.uniform(), random.uniform()),
        extent(random.uniform(), random.uniform(), random.uniform());
    boxes.push_back({unit * corner, unit * (corner + extent / 8)});
  }
  return boxes;
}

TEST(box_tree, visits_until_no_box_is_nearer) {
  for (const double unit : {1e-300, 1.0, 1e300}) {
    const std::vector<Box> boxes = random_boxes(200, unit);
    const BoxTree tree(boxes);
    for (const Vec3<double>& from : {Vec3<double>(0.5, 0.5, 0.5), {2, 0, -1}, {0, 0, 0}}) {
      double least = std::numeric_limits<double>::infinity(), found = least;
      for (const Box& box : boxes) least = std::min(least, distance_to(box, unit * from));
      int visits = 0;
      tree.by_distance(unit * from, [&](int i) {
        ++visits;
        return found = std::min(found, distance_to(boxes[i], unit * from));
      });
      EXPECT_EQ(found, least) << unit;
      EXPECT_LT(visits, 60) << unit;
    }
  }
}

// So far away that squares of distances overflow, all are asked.
TEST(box_tree, finds_the_nearest_from_anywhere) {
  const std::vector<Box> boxes = random_boxes(50, 1e-300);
  const Vec3<double> from(1e200, -1e250, 0);
  std::vector<int> seen;
  BoxTree(boxes).by_distance(from, [&](int i) {
    seen.push_back(i);
    return distance_to(boxes[i], from);
  });
  EXPECT_EQ(seen.size(), boxes.size());
}

}  // namespace
}  // namespace cageproof
