// SPDX-License-Identifier: MIT
// Answers of the hierarchy against questions to every box.
#include "geometry/box_hierarchy.h"

#include "cageproof/core/numbers/random_stream.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

namespace cageproof {
namespace {

constexpr double inf = std::numeric_limits<double>::infinity();

bool meet(const Box& a, const Box& b) {
  return (a.low.array() <= b.high.array()).all() && (b.low.array() <= a.high.array()).all();
}

std::vector<int> found_in(const BoxHierarchy& hierarchy, const Box& box) {
  std::vector<int> found;
  hierarchy.for_each_meeting(box, [&](int i) {
    found.push_back(i);
    return true;
  });
  std::ranges::sort(found);
  return found;
}

// Expects each box that meets the given one to be found once. \return how many others are found
std::size_t others_found(const std::vector<Box>& boxes, const BoxHierarchy& hierarchy, const Box& box) {
  const std::vector<int> found = found_in(hierarchy, box);
  EXPECT_EQ(std::ranges::adjacent_find(found), found.end());
  std::size_t meeting = 0;
  for (int i = 0; i < static_cast<int>(boxes.size()); ++i) {
    if (!meet(boxes[i], box)) continue;
    ++meeting;
    EXPECT_TRUE(std::ranges::binary_search(found, i)) << i;
  }
  return found.size() - meeting;
}

// Corners on a grid, so that many boxes touch, and among them flat ones.
std::vector<Box> boxes_on_grid(int count, double unit, const Vec3<double>& origin) {
  std::vector<Box> boxes;
  for (int i = 0; i < count; ++i) {
    RandomStream random(8, "boxes on a grid", i);
    Box box;
    for (int c = 0; c < 3; ++c) {
      box.low[c] = origin[c] + unit * random.below(16);
      box.high[c] = box.low[c] + unit * random.below(3);
    }
    boxes.push_back(box);
  }
  return boxes;
}

// In units without roundings, in which what meets is decided by whole numbers.
TEST(box_hierarchy, finds_every_box_that_meets) {
  for (const double unit : {0x1p-1022, 1.0, 0x1p1003})
    for (const Vec3<double>& origin : {Vec3<double>(0, 0, 0), Vec3<double>(-7, 3, 99999)})
      for (const int count : {1, 2, 4, 5, 17, 64, 1000}) {
        const std::vector<Box> boxes = boxes_on_grid(count, unit, unit * origin);
        const BoxHierarchy hierarchy(boxes);
        std::size_t others = 0;
        for (int i = 0; i < 200; ++i) {
          RandomStream random(9, "questions", i);
          Vec3<double> p;
          for (int c = 0; c < 3; ++c)
            p[c] = unit * origin[c] + unit * (i % 2 == 0 ? random.below(19) : random.uniform(0, 19));
          Box ray{p, p};
          ray.high[i % 3] = inf;
          others += others_found(boxes, hierarchy, {p, p}) + others_found(boxes, hierarchy, ray);
        }
        EXPECT_LE(others, 4U) << "a thousandth of what could be found besides";
      }
}

TEST(box_hierarchy, of_boxes_that_are_all_the_same_holds_all) {
  const std::vector<Box> boxes(100, Box{{1, 2, 3}, {1, 2, 3}});
  const BoxHierarchy hierarchy(boxes);
  EXPECT_EQ(found_in(hierarchy, boxes[0]).size(), 100U);
  EXPECT_EQ(found_in(hierarchy, {{1, 2, 4}, {1, 2, 4}}).size(), 0U);
}

TEST(box_hierarchy, nothing_meets_what_is_no_number_or_beyond_all) {
  const BoxHierarchy hierarchy(boxes_on_grid(50, 1, {0, 0, 0}));
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(found_in(hierarchy, {{nan, 1, 1}, {nan, 1, 1}}).empty());
  EXPECT_TRUE(found_in(hierarchy, {{1, 1, inf}, {1, 1, inf}}).empty());
  EXPECT_TRUE(found_in(hierarchy, {{1, -1e308, 1}, {1, -1e308, 1}}).empty());
  EXPECT_EQ(found_in(hierarchy, {{-inf, -inf, -inf}, {inf, inf, inf}}).size(), 50U);
  EXPECT_TRUE(found_in(BoxHierarchy({}), {{-inf, -inf, -inf}, {inf, inf, inf}}).empty());
}

TEST(box_hierarchy, ends_where_it_is_told_to) {
  const BoxHierarchy hierarchy(boxes_on_grid(50, 1, {0, 0, 0}));
  int calls = 0;
  hierarchy.for_each_meeting({{-inf, -inf, -inf}, {inf, inf, inf}}, [&](int) { return ++calls < 7; });
  EXPECT_EQ(calls, 7);
}

// A question about a point goes down a few branches, not all.
TEST(box_hierarchy, asks_few_of_many) {
  std::vector<Box> boxes;
  for (int x = 0; x < 64; ++x)
    for (int y = 0; y < 64; ++y) boxes.push_back({Vec3<double>(x, y, 0), Vec3<double>(x + 1, y + 1, 0.5)});
  const BoxHierarchy hierarchy(boxes);
  for (int i = 0; i < 64; ++i) EXPECT_EQ(found_in(hierarchy, {{i + 0.5, 0.5, 0}, {i + 0.5, 0.5, inf}}).size(), 1U);
}

}  // namespace
}  // namespace cageproof
