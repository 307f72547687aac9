// SPDX-License-Identifier: MIT
// Places against what is known: a cage's against exact winding numbers, an open mesh's against solid angles that
// symmetry gives, and both against each other.
#include "cageproof/core/cage/point_places.h"

#include "cageproof/core/cage/embedded_cages.h"
#include "cageproof/core/input_error.h"
#include "cageproof/core/numbers/random_stream.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace cageproof::point_places_test {
namespace {

using Faces = std::vector<std::vector<int>>;

const std::vector<Vec3<double>> corners{{-1, -1, -1}, {1, -1, -1}, {1, 1, -1}, {-1, 1, -1},
                                        {-1, -1, 1},  {1, -1, 1},  {1, 1, 1},  {-1, 1, 1}};
const Faces sides{{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}};

Faces faces_of(const Cage& cage) {
  Faces faces;
  for (const Face& face : cage.faces()) faces.emplace_back(face.vertices.begin(), face.vertices.begin() + face.size());
  return faces;
}

TEST(point_places, of_a_cube_without_lid_are_sixths) {
  Faces open = sides;
  open.pop_back();
  const PointPlaces places(corners, open);
  EXPECT_FALSE(places.is_closed());
  const PointPlace centre = places.at({0, 0, 0});
  EXPECT_EQ(centre.place, Place::Inside);
  EXPECT_LE(std::abs(centre.winding - 5.0 / 6), centre.bound);
  EXPECT_LT(centre.bound, 1e-13);
  EXPECT_EQ(places.at({-1, 0.5, 0.25}).place, Place::Outside);  // in the hole
  const PointPlace on = places.at({0.25, 0.5, 1});
  EXPECT_EQ(on.place, Place::On);
  EXPECT_EQ(on.face, 1);
  EXPECT_TRUE(std::isnan(on.winding));
  EXPECT_EQ(places.at({1, 1, 0.125}).face, 3);  // the first of two
  EXPECT_EQ(places.at({2, 0, 0}).place, Place::Outside);
}

TEST(point_places, of_closed_faces_are_those_of_the_cage) {
  for (const char* name : {"cube", "l-block", "torus", "spiky-box", "thin-wall-1e-12", "nested", "icosphere"}) {
    const Cage cage = embedded_cage(name);
    const PointPlaces exact(cage, false, Triangulation::Shortest), summed(cage.vertices(), faces_of(cage));
    ASSERT_TRUE(summed.is_closed()) << name;
    int counts[3] = {0, 0, 0};
    for (int i = 0; i < 300; ++i) {
      RandomStream random(5, name, i);
      Vec3<double> p;
      // Every third point has coordinates of vertices, every third is next to a vertex by a few units in the last
      // place.
      const int v = random.below(static_cast<int>(cage.vertices().size()));
      for (int c = 0; c < 3; ++c)
        p[c] = i % 3 == 0   ? random.uniform(-1.2, 1.2)
               : i % 3 == 1 ? cage.vertices()[random.below(static_cast<int>(cage.vertices().size()))][c]
                            : cage.vertices()[v][c] * (1 + std::ldexp(random.below(9) - 4, -52));
      const PointPlace a = exact.at(p), b = summed.at(p);
      EXPECT_EQ(a.place, b.place) << name << ' ' << p.transpose();
      EXPECT_EQ(a.face, b.face) << name << ' ' << p.transpose();
      if (a.place != Place::On) {
        EXPECT_EQ(a.winding, b.winding) << name << ' ' << p.transpose();
        EXPECT_EQ(b.bound, 0) << name;
      }
      ++counts[static_cast<int>(a.place) + 1];
    }
    EXPECT_TRUE(counts[0] > 0 && counts[1] > 0) << name;
  }
}

TEST(point_places, next_to_an_edge_keep_their_bound) {
  // The top and one side of the cube, from 2^-52 of the middle of their edge, in and out. The faces that are missing
  // look the same from both places, so that the difference is that of the closed cube.
  const PointPlaces places(corners, {sides[1], sides[3]});
  const PointPlace in = places.at({1 - 0x1p-52, 0, 1 - 0x1p-52}), out = places.at({1 + 0x1p-51, 0, 1 + 0x1p-51});
  EXPECT_LT(in.bound, 1e-13);
  EXPECT_LT(out.bound, 1e-13);
  EXPECT_NEAR(in.winding - out.winding, 1, 1e-13);
}

TEST(point_places, hold_in_any_unit_and_turned_over) {
  for (const double unit : {1e-300, 1e-100, 1.0, 1e100, 1e300}) {
    std::vector<Vec3<double>> vertices = corners;
    for (Vec3<double>& v : vertices) v *= unit;
    Faces turned = sides;
    for (auto& face : turned) std::ranges::reverse(face);
    const PointPlaces places(vertices, turned);
    EXPECT_EQ(places.at(Vec3<double>(0.5, 0.25, 0) * unit).winding, -1);
    EXPECT_EQ(places.at(Vec3<double>(0.5, 0.25, 0) * unit).place, Place::Inside);
    EXPECT_EQ(places.at(Vec3<double>(1, 0.25, 0) * unit).place, Place::On);
    EXPECT_EQ(places.at(Vec3<double>(1.5, 0.25, 0) * unit).place, Place::Outside);
  }
}

TEST(point_places, refuse_faces_that_are_none) {
  EXPECT_THROW(PointPlaces(corners, {{0, 1, 99}}), InputError);
  EXPECT_THROW(PointPlaces(corners, {{0, 1}}), InputError);
  EXPECT_THROW(PointPlaces({{0, 0, 0}, {1, 0, 0}, {0, NAN, 0}}, {{0, 1, 2}}), InputError);
  EXPECT_EQ(PointPlaces(corners, sides).at({NAN, 0, 0}).place, Place::Outside);
}

}  // namespace
}  // namespace cageproof::point_places_test
