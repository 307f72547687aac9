// SPDX-License-Identifier: MIT
// Elements of a cage of quads and triangles: their corners, owners and normals.
#include "cageproof/core/cage/cage_elements.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace cageproof {
namespace {

// Two triangles and three quads between them.
Cage prism() {
  return Cage::make("prism", {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {0, 1, 1}},
                    {{{0, 2, 1, -1}}, {{3, 4, 5, -1}}, {{0, 1, 4, 3}}, {{1, 2, 5, 4}}, {{2, 0, 3, 5}}}, {});
}

TEST(cage_elements, number_their_corners_one_after_the_other) {
  const Cage cage = prism();
  const CageElements elements(cage, true, Triangulation::Shortest);
  ASSERT_EQ(elements.count(), 5U);
  EXPECT_EQ(elements.count(Owner::Vertex), 6U);
  EXPECT_EQ(elements.count(Owner::Element), 5U);
  EXPECT_EQ(elements.count(Owner::Corner), 18U);
  int next = 0;
  for (std::size_t e = 0; e < elements.count(); ++e) {
    const auto vertices = elements.vertices_of(e), corners = elements.shares_of(e, Owner::Corner),
               own = elements.shares_of(e, Owner::Element), of_vertices = elements.shares_of(e, Owner::Vertex);
    EXPECT_EQ(corners.size(), vertices.size()) << e;
    for (const int corner : corners) {
      EXPECT_EQ(corner, next++);
      EXPECT_EQ(elements.element_of(corner, Owner::Corner), e);
    }
    ASSERT_EQ(own.size(), 1U);
    EXPECT_EQ(own[0], static_cast<int>(e));
    EXPECT_EQ(elements.element_of(own[0], Owner::Element), e);
    EXPECT_TRUE(std::ranges::equal(of_vertices, vertices));
  }
  EXPECT_EQ(next, 18);
}

TEST(cage_elements, owners_have_names) {
  EXPECT_EQ(name_of(Owner::Vertex), "vertex");
  EXPECT_EQ(name_of(Owner::Element), "element");
  EXPECT_EQ(name_of(Owner::Corner), "corner");
}

}  // namespace
}  // namespace cageproof
