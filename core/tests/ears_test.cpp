// SPDX-License-Identifier: MIT
#include "cage/ears.h"

#include <gtest/gtest.h>

#include <cmath>

namespace cageproof {
namespace {

using Corners = std::vector<Vec3<double>>;

// That the triangles have the polygon's area, each some of it.
void expect_cover(const Corners& corners) {
  const auto triangles = ears_of(corners);
  ASSERT_EQ(triangles.size(), corners.size() - 2);
  Vec3<double> whole = Vec3<double>::Zero(), sum = Vec3<double>::Zero();
  for (std::size_t k = 1; k + 1 < corners.size(); ++k)
    whole += (corners[k] - corners[0]).cross(corners[k + 1] - corners[0]);
  for (const auto& t : triangles) {
    const Vec3<double> area = (corners[t[1]] - corners[t[0]]).cross(corners[t[2]] - corners[t[0]]);
    EXPECT_GT(area.dot(whole), 0);
    sum += area;
  }
  EXPECT_NEAR((sum - whole).norm(), 0, 1e-14 * whole.norm());
}

TEST(Ears, cover_convex_and_concave_polygons_in_any_plane_and_direction) {
  const Corners star = [] {
    Corners made;
    for (int k = 0; k < 10; ++k) {
      const double angle = 0.3 + k * 0.62831853, r = k % 2 == 0 ? 2 : 0.75;
      made.emplace_back(r * std::cos(angle), r * std::sin(angle), 0);
    }
    return made;
  }();
  const Corners stairs{{0, 0, 0}, {3, 0, 0}, {3, 1, 0}, {2, 1, 0}, {2, 2, 0}, {1, 2, 0}, {1, 3, 0}, {0, 3, 0}};
  for (const Corners& flat : {star, stairs})
    for (int axis = 0; axis < 3; ++axis)
      for (const bool reversed : {false, true})
        for (std::size_t first = 0; first < flat.size(); ++first) {
          Corners corners;
          for (std::size_t k = 0; k < flat.size(); ++k) {
            const Vec3<double>& p = flat[(reversed ? flat.size() - k + first : k + first) % flat.size()];
            Vec3<double> turned;
            for (int i = 0; i < 3; ++i) turned[(i + axis) % 3] = p[i];
            corners.push_back(turned);
          }
          expect_cover(corners);
        }
}

TEST(Ears, cover_a_polygon_of_many_corners) {
  Corners round;
  for (int k = 0; k < 2000; ++k) round.emplace_back(std::cos(k * M_PI / 1000), std::sin(k * M_PI / 1000), 0);
  EXPECT_EQ(ears_of(round).size(), 1998U);
  // Every second corner is reflex.
  for (int k = 0; k < 2000; k += 2) round[k] *= 0.999;
  EXPECT_EQ(ears_of(round).size(), 1998U);
}

TEST(Ears, pass_corners_on_a_line_and_polygons_a_rounding_off_their_plane) {
  expect_cover({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {2, 1, 0}, {2, 2, 0}, {0, 2, 0}});
  expect_cover({{0, 0, 0}, {1, 0, 1e-16}, {2, 1, -1e-16}, {1, 2, 0}, {0, 1, 2e-17}});
}

TEST(Ears, are_none_of_what_crosses_itself_or_has_no_area) {
  // A pentagram, whose ears all turn left.
  EXPECT_TRUE(ears_of(Corners{{0, 3, 0}, {-2, -3, 0}, {3, 1, 0}, {-3, 1, 0}, {2, -3, 0}}).empty());
  EXPECT_TRUE(ears_of(Corners{{0, 0, 0}, {2, 0, 0}, {0, 1, 0}, {2, 2, 0}, {1, 0.5, 0}}).empty());
  EXPECT_TRUE(ears_of(Corners{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}, {4, 0, 0}}).empty());
}

}  // namespace
}  // namespace cageproof
