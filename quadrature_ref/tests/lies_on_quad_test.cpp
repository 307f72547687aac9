// SPDX-License-Identifier: MIT
// Whether points lie on quads: by hand, and as core says, with which the integral's decision shares no code.
#include "../src/rules/quad/inside_quad.h"

#include "cageproof/core/geometry/quad_geometry.h"
#include "cageproof/core/numbers/random_stream.h"

#include <gtest/gtest.h>

namespace cageproof::quadrature_ref {
namespace {

using Vec = Vec3<double>;

bool lies_on(const Quad<double>& quad, const Vec& point) {
  std::vector<Vec3<Mp200>> corners;
  for (const Vec& corner : quad) corners.push_back(cageproof::convert<Mp200>(corner));
  return lies_on_quad({corners, cageproof::convert<Mp200>(point), 0, {}, false});
}

const Quad<double> kSquare{Vec(0, 0, 0), Vec(1, 0, 0), Vec(1, 1, 0), Vec(0, 1, 0)};
const Quad<double> kTwisted{Vec(0, 0, 0), Vec(1, 0, 0), Vec(1, 1, 1), Vec(0, 1, 0)};  // z = x y
const Quad<double> kDart{Vec(0, 0, 0), Vec(4, 0, 0), Vec(1, 1, 0), Vec(0, 4, 0)};

TEST(LiesOnQuad, says_so_to_the_last_bit) {
  const double tiny = 0x1p-1074;
  for (const double u : {0., 0.25, 0.5, 1.})
    for (const double v : {0., 0.125, 0.75, 1.}) {
      EXPECT_TRUE(lies_on(kSquare, {u, v, 0}));
      EXPECT_FALSE(lies_on(kSquare, {u, v, tiny}));
      EXPECT_TRUE(lies_on(kTwisted, {u, v, u * v}));
      EXPECT_FALSE(lies_on(kTwisted, {u, v, u * v - tiny - 0x1p-53}));
    }
  EXPECT_FALSE(lies_on(kSquare, {-tiny, 0.5, 0}));
  EXPECT_FALSE(lies_on(kSquare, {1.5, 0, 0}));
  EXPECT_FALSE(lies_on(kTwisted, {1.5, 0.5, 0.75}));
}

// The quad covers more than the polygon of its corners: rows run from side to side.
TEST(LiesOnQuad, follows_the_rows_of_concave_quads) {
  EXPECT_TRUE(lies_on(kDart, {0.5, 0.5, 0}));
  EXPECT_TRUE(lies_on(kDart, {1, 1, 0}));
  EXPECT_FALSE(lies_on(kDart, {3, 3, 0}));
}

TEST(LiesOnQuad, is_what_core_says) {
  RandomStream random(3, "lies on quad", 0);
  int on = 0;
  for (int sample = 0; sample < 20000; ++sample) {
    const bool plane = sample % 2 == 0;
    const auto integers = [&] { return Vec(random.below(5), random.below(5), plane ? 0 : random.below(3)); };
    const Quad<double> quad{integers(), integers(), integers(), integers()};
    const Vec point = sample % 3 == 0 ? Vec(integers() / 2) : integers();
    const bool expected = on_quad(quad, point).has_value();
    EXPECT_EQ(lies_on(quad, point), expected)
        << quad[0].transpose() << "; " << quad[1].transpose() << "; " << quad[2].transpose() << "; "
        << quad[3].transpose() << " from " << point.transpose();
    on += expected;
  }
  EXPECT_GT(on, 1000);
}

}  // namespace
}  // namespace cageproof::quadrature_ref
