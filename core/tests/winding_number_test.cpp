// SPDX-License-Identifier: MIT
#include "cageproof/core/geometry/winding_number.h"

#include "cageproof/core/cage/embedded_cages.h"
#include "cageproof/core/numbers/random_stream.h"
#include "support.h"

#include <cmath>
#include <limits>

namespace cageproof::winding_number_test {
namespace {

std::vector<Triangle<double>> triangles_of(const Cage& cage) {
  std::vector<Triangle<double>> found;
  for (const auto& [a, b, c] : cage.triangulate(Triangulation::Shortest).triangles)
    found.push_back({cage.vertices()[a], cage.vertices()[b], cage.vertices()[c]});
  return found;
}

// The solid angle over 4 pi (van Oosterom, Strackee), which counts no crossings.
double turns(const std::vector<Triangle<double>>& triangles, const Vec3<double>& point) {
  double sum = 0;
  for (const Triangle<double>& t : triangles) {
    const Vec3<double> a = (t[0] - point).normalized(), b = (t[1] - point).normalized(),
                       c = (t[2] - point).normalized();
    sum += 2 * std::atan2(a.dot(b.cross(c)), 1 + a.dot(b) + b.dot(c) + c.dot(a));
  }
  return sum / (4 * std::acos(-1.0));
}

TEST(winding_number, agrees_with_the_solid_angle) {
  for (const char* name : {"cube", "torus", "l-block", "spiky-box", "thin-box"}) {
    const Cage cage = embedded_cage(name);
    std::vector<Triangle<double>> triangles = triangles_of(cage);
    // A second, smaller copy, moved and turned over: numbers from -1 to 1.
    const std::size_t count = triangles.size();
    for (std::size_t i = 0; i < count; ++i) {
      Triangle<double> t = triangles[i];
      for (auto& v : t) v = 0.75 * v + Vec3<double>(0.5, 0.125, 0.0625);
      triangles.push_back({t[0], t[2], t[1]});
    }
    int seen = 0;
    for (int i = 0; i < 300; ++i) {
      RandomStream random(1, name, i);
      const double x = random.uniform(-1.5, 1.5), y = random.uniform(-1.5, 1.5), z = random.uniform(-0.75, 0.75);
      const auto found = winding_number(triangles, Vec3<double>(x, y, z));
      ASSERT_TRUE(found);
      EXPECT_NEAR(*found, turns(triangles, {x, y, z}), 1e-6) << name;
      seen |= 1 << (*found + 1);
    }
    EXPECT_EQ(seen, 7) << name;
  }
}

// Every ray within the plane of a surface without volume runs along its triangles, so only the box ends the search.
TEST(winding_number, is_zero_beside_a_surface_without_a_volume) {
  const Triangle<double> front{Vec3<double>(0, 0, 0), Vec3<double>(1, 0, 0), Vec3<double>(0, 1, 0)};
  const std::vector<Triangle<double>> both{front, {front[0], front[2], front[1]}};
  for (const Vec3<double>& beside : {Vec3<double>(-1, 0.25, 0), {0.25, -1, 0}, {2, 0.25, 0}, {0.25, 2, 0}})
    EXPECT_EQ(winding_number(both, beside), 0);
}

TEST(winding_number, knows_the_surface_exactly) {
  const std::vector<Triangle<double>> cube = triangles_of(embedded_cage("cube"));
  for (const Vec3<double>& on : {Vec3<double>(0.5, 0.5, 0.5), {0.5, 0.5, 0}, {0.5, 0.125, 0.25}, {0.5, 0.25, 0.25}})
    EXPECT_FALSE(winding_number(cube, on));
  const double inside = std::nextafter(0.5, 0.0), outside = std::nextafter(0.5, 1.0);
  EXPECT_EQ(winding_number(cube, Vec3<double>(inside, inside, inside)), 1);
  EXPECT_EQ(winding_number(cube, Vec3<double>(inside, 0, 0)), 1);
  EXPECT_EQ(winding_number(cube, Vec3<double>(outside, 0, 0)), 0);
  EXPECT_EQ(winding_number(cube, Vec3<double>(0, 0, 0)), 1);
  EXPECT_EQ(winding_number(cube, Vec3<double>(0, 0, std::numeric_limits<double>::denorm_min())), 1);
}

TEST(winding_number, in_the_plane) {
  const std::vector<Segment<double>> square{
      {{{0, 0, 0}, {1, 0, 0}}}, {{{1, 0, 0}, {1, 1, 0}}}, {{{1, 1, 0}, {0, 1, 0}}}, {{{0, 1, 0}, {0, 0, 0}}}};
  for (const double y : {0.25, 0.5}) EXPECT_EQ(winding_number(square, Vec3<double>(0.5, y, 0)), 1);
  for (const Vec3<double>& out : {Vec3<double>(-1, 0, 0), {-1, 1, 0}, {2, 0, 0}, {2, 1, 0}, {0.5, 2, 0}, {-1, 0.5, 0}})
    EXPECT_EQ(winding_number(square, out), 0);
  for (const Vec3<double>& on : {Vec3<double>(0, 0, 0), {1, 0.5, 0}, {0.5, 1, 0}, {1, 1, 0}})
    EXPECT_FALSE(winding_number(square, on));
  // A diamond, whose corners lie on the ray.
  const std::vector<Segment<double>> diamond{
      {{{1, 0, 0}, {0, 1, 0}}}, {{{0, 1, 0}, {-1, 0, 0}}}, {{{-1, 0, 0}, {0, -1, 0}}}, {{{0, -1, 0}, {1, 0, 0}}}};
  EXPECT_EQ(winding_number(diamond, Vec3<double>(0, 0, 0)), 1);
  EXPECT_EQ(winding_number(diamond, Vec3<double>(-2, 0, 0)), 0);
}

}  // namespace
}  // namespace cageproof::winding_number_test
