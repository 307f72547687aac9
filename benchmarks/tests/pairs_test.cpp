// SPDX-License-Identifier: MIT
#include "pairs.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

namespace cageproof::benchmarks {
namespace {

constexpr std::array kElements{ElementKind::Segment, ElementKind::Triangle, ElementKind::Quad};

TEST(Pairs, are_the_same_in_every_call) {
  for (const ElementKind element : kElements) {
    SCOPED_TRACE(name_of(element));
    const auto first = generic_pairs(element), second = generic_pairs(element);
    ASSERT_EQ(first.size(), static_cast<std::size_t>(kPairCount));
    ASSERT_EQ(second.size(), first.size());
    for (std::size_t i = 0; i < first.size(); ++i) {
      EXPECT_EQ(first[i].corners, second[i].corners);
      EXPECT_EQ(first[i].point, second[i].point);
      EXPECT_TRUE(i == 0 || first[i].point != first[i - 1].point);
    }
  }
}

void expect_generic(ElementKind element) {
  SCOPED_TRACE(name_of(element));
  for (const Pair& pair : generic_pairs(element)) {
    ASSERT_EQ(pair.corners.size(), static_cast<std::size_t>(corner_count(element)));
    Vec3<double> centroid = Vec3<double>::Zero();
    double longest = 0;
    for (const auto& a : pair.corners) {
      centroid += a / corner_count(element);
      for (const auto& b : pair.corners) longest = std::max(longest, (a - b).norm());
    }
    EXPECT_NEAR(longest, 1, 1e-12);
    EXPECT_GT((pair.point - centroid).norm(), 0.5 - 1e-12);
    EXPECT_LT((pair.point - centroid).norm(), 1.5 + 1e-12);
    EXPECT_TRUE(dimension(element) == 3 || pair.point[2] == 0);
  }
}

TEST(Pairs, are_at_generic_distance) {
  for (const ElementKind element : kElements) expect_generic(element);
}

}  // namespace
}  // namespace cageproof::benchmarks
