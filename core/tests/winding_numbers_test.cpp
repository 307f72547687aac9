// SPDX-License-Identifier: MIT
// The tree's winding numbers against those of winding_number(), which asks all triangles for a ray in any direction.
#include "cageproof/core/cage/winding_numbers.h"

#include "cageproof/core/cage/embedded_cages.h"
#include "cageproof/core/geometry/winding_number.h"
#include "cageproof/core/numbers/random_stream.h"
#include "support.h"

#include <algorithm>

namespace cageproof {
namespace {

std::vector<Triangle<double>> all_triangles(const CageElements& elements) {
  std::vector<Triangle<double>> all;
  for (std::size_t e = 0; e < elements.count(); ++e) {
    const auto c = elements.corners(e);
    all.push_back({c[0], c[1], c[2]});
  }
  return all;
}

// Anywhere, at vertices, and at coordinates of vertices mixed, which are above edges and vertices along every axis.
std::vector<Vec3<double>> asked_points(const Cage& cage, int count) {
  const auto [low, high] = box_of(cage.vertices());
  const auto& vertices = cage.vertices();
  std::vector<Vec3<double>> points(vertices.begin(),
                                   vertices.begin() + std::min<std::ptrdiff_t>(40, std::ssize(vertices)));
  for (int i = 0; i < count; ++i) {
    RandomStream random(3, cage.name(), i);
    Vec3<double> p = Vec3<double>::Zero();
    for (int c = 0; c < cage.dimension(); ++c) {
      const double share = random.uniform(-0.1, 1.1);
      p[c] = i % 2 == 0 ? low[c] + share * (high[c] - low[c])
                        : vertices[random.below(static_cast<int>(vertices.size()))][c];
      if (i % 4 == 3) p[c] = (p[c] + vertices[random.below(static_cast<int>(vertices.size()))][c]) / 2;
    }
    points.push_back(p);
  }
  return points;
}

TEST(winding_numbers, of_triangles_are_those_of_any_ray) {
  for (const char* name : {"cube", "torus", "l-block", "spiky-box", "thin-box", "icosphere", "twisted-bar"}) {
    const Cage cage = embedded_cage(name);
    const CageElements elements(cage, false, Triangulation::Shortest);
    const WindingNumbers windings(elements);
    const auto triangles = all_triangles(elements);
    int on = 0, in = 0, out = 0;
    for (const Vec3<double>& p : asked_points(cage, 400)) {
      const auto found = windings.around(p);
      ASSERT_EQ(found, winding_number(triangles, p)) << name << ' ' << p.transpose();
      ++(!found ? on : *found == 1 ? in : out);
    }
    EXPECT_TRUE(on > 0 && in > 0 && out > 0) << name << ' ' << on << ' ' << in << ' ' << out;
  }
}

TEST(winding_numbers, of_polygons_are_those_of_a_ray_along_the_other_axis) {
  for (const auto name : embedded_cage_names()) {
    const Cage cage = embedded_cage(name);
    if (cage.dimension() != 2) continue;
    const CageElements elements(cage, false, Triangulation::Shortest);
    const WindingNumbers windings(elements);
    std::vector<Segment<double>> segments;
    for (std::size_t e = 0; e < elements.count(); ++e)
      segments.push_back({elements.corners(e)[0], elements.corners(e)[1]});
    for (const Vec3<double>& p : asked_points(cage, 400))
      ASSERT_EQ(windings.around(p), winding_number(segments, p)) << cage.name() << ' ' << p.transpose();
  }
}

// One inside the other, turned over: numbers of 1 and 0, also where units are at the ends of the range.
TEST(winding_numbers, hold_in_any_unit) {
  const Cage cube = embedded_cage("cube");
  for (const double unit : {1e-300, 1e-160, 1.0, 1e160, 1e300}) {
    std::vector<Vec3<double>> vertices = cube.vertices();
    for (Vec3<double>& v : vertices) v *= unit;
    const WindingNumbers windings(CageElements(cube.with(vertices, cube.faces()), true, Triangulation::Shortest));
    EXPECT_EQ(windings.around(Vec3<double>(0.125, 0.25, 0) * unit), 1) << unit;
    EXPECT_EQ(windings.around(Vec3<double>(0.5, 0.25, 0) * unit), std::nullopt) << unit;
    EXPECT_EQ(windings.around(Vec3<double>(0.125, 0.75, 0) * unit), 0) << unit;
    EXPECT_EQ(windings.around(Vec3<double>(1e308, 1e308, -1e308)), 0) << unit;
  }
}

}  // namespace
}  // namespace cageproof
