// SPDX-License-Identifier: MIT
// The integral's exact geometry against that of the closed forms: they share no code, and both round an exact number
// once.
#include "../src/rules/exact_element.h"

#include "cageproof/core/geometry/exact_geometry.h"
#include "cageproof/core/numbers/random_stream.h"

#include <gtest/gtest.h>

#include <cmath>

namespace cageproof::quadrature_ref {
namespace {

// Points and corners of every kind: small integers, random ones, spread over the exponents of doubles.
struct Inputs {
  RandomStream random;
  int spread;

  double number() {
    if (spread == 0) return std::floor(random.uniform(-3, 4));
    return std::ldexp(random.uniform(-1, 1), static_cast<int>(random.uniform(-spread, spread)));
  }
  Vec3<Mp200> operator()() { return {Mp200(number()), Mp200(number()), Mp200(number())}; }
};

template <class Ask>
void for_inputs(const Ask& ask) {
  for (const int spread : {0, 1, 40, 54, 60, 1000})
    for (int sample = 0; sample < 200; ++sample)
      ask(Inputs{RandomStream(7, "exact element", static_cast<std::uint64_t>(1000 * spread + sample)), spread});
}

TEST(ExactElement, triangles_are_those_of_core) {
  for_inputs([](Inputs input) {
    const std::array<Vec3<Mp200>, 3> t{input(), input(), input()};
    const Vec3<Mp200> point = input();
    const auto found = exact_triangle(t, point, 0);
    ASSERT_TRUE(found);
    const ExactTriangleIn<Mp200> core(t, point);
    EXPECT_EQ(found->corners, core.p);
    EXPECT_EQ(found->edges, core.e);
    EXPECT_EQ(found->normal, core.normal);
    EXPECT_EQ(found->outward, core.outward);
    EXPECT_EQ(found->volume, core.volume);
    EXPECT_EQ(found->inside, core.beside);
    EXPECT_EQ(found->start, core.before);
    EXPECT_EQ(found->end, core.after);
  });
}

TEST(ExactElement, segments_are_those_of_core) {
  for_inputs([](Inputs input) {
    const std::array<Vec3<Mp200>, 2> s{input(), input()};
    const Vec3<Mp200> point = input();
    const auto found = exact_segment(s, point, 0);
    ASSERT_TRUE(found);
    const ExactSegmentIn<Mp200> core(s, point);
    EXPECT_EQ(found->height, -core.cross);
    EXPECT_EQ(found->start, core.before);
    EXPECT_EQ(found->end, core.after);
  });
}

TEST(ExactElement, heights_of_quads_are_those_of_their_corners) {
  for_inputs([](Inputs input) {
    const std::array<Vec3<Mp200>, 4> q{input(), input(), input(), input()};
    const Vec3<Mp200> point = input();
    const auto found = exact_volumes(q, point, 0);
    ASSERT_TRUE(found);
    for (int k = 0; k < 4; ++k)
      EXPECT_EQ((*found)[k], ExactTriangleIn<Mp200>({q[k], q[(k + 1) % 4], q[(k + 3) % 4]}, point).volume);
  });
}

// By hand: the unit right triangle from a point over it; lengths are halves of the given unit.
TEST(ExactElement, says_where_a_point_is) {
  const std::array<Vec3<Mp200>, 3> t{Vec3<Mp200>(0, 0, 0), Vec3<Mp200>(1, 0, 0), Vec3<Mp200>(0, 1, 0)};
  const auto found = exact_triangle(t, Vec3<Mp200>(Mp200(0.25), Mp200(0.5), ldexp(Mp200(1), -3000)), 1);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->volume, -ldexp(Mp200(1), -3003));
  EXPECT_EQ(found->inside[0], Mp200(0.5) / 16);
  EXPECT_EQ(found->inside[1], Mp200(0.25) / 16);
  EXPECT_EQ(found->start[0], Mp200(-0.25) / 4);
  EXPECT_EQ(found->end[0], Mp200(0.75) / 4);
}

TEST(ExactElement, declines_what_no_exact_number_can_hold) {
  const std::array<Vec3<Mp200>, 2> s{Vec3<Mp200>(0, 0, 0), Vec3<Mp200>(1, 0, 0)};
  EXPECT_TRUE(exact_segment(s, Vec3<Mp200>(ldexp(Mp200(1), -90000), 0, 0), 0));
  EXPECT_FALSE(exact_segment(s, Vec3<Mp200>(ldexp(Mp200(1), -110000), 0, 0), 0));
  EXPECT_FALSE(exact_segment(s, Vec3<Mp200>(std::numeric_limits<Mp200>::infinity(), 0, 0), 0));
}

}  // namespace
}  // namespace cageproof::quadrature_ref
