// SPDX-License-Identifier: MIT
// The tree's answers equal those of walks over all elements: winding numbers equal winding_number(), which intersects
// all triangles with a ray in any direction, and touching elements equal the contacts with each.
#include "cageproof/core/cage/winding_numbers.h"

#include "cageproof/core/cage/embedded_cages.h"
#include "cageproof/core/geometry/winding_number.h"
#include "cageproof/core/numbers/random_stream.h"
#include "support.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace cageproof::winding_numbers_test {
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

// The faces of a box of integer corners, each cut in unit squares of two triangles.
Cage box_of_units(const std::array<int, 3>& sizes) {
  std::map<std::array<int, 3>, int> numbers;
  std::vector<Vec3<double>> vertices;
  const auto vertex = [&](const std::array<int, 3>& at) {
    const auto [found, is_new] = numbers.try_emplace(at, static_cast<int>(vertices.size()));
    if (is_new) vertices.emplace_back(at[0], at[1], at[2]);
    return found->second;
  };
  std::vector<Face> faces;
  for (int axis = 0; axis < 3; ++axis)
    for (const bool high : {false, true}) {
      const int u = (axis + 1) % 3, v = (axis + 2) % 3;
      for (int i = 0; i < sizes[u]; ++i)
        for (int j = 0; j < sizes[v]; ++j) {
          const auto corner = [&](int along_u, int along_v) {
            std::array<int, 3> at{};
            at[axis] = high ? sizes[axis] : 0;
            at[u] = i + along_u;
            at[v] = j + along_v;
            return vertex(at);
          };
          const int a = corner(0, 0), b = corner(high ? 1 : 0, high ? 0 : 1), c = corner(1, 1),
                    d = corner(high ? 0 : 1, high ? 1 : 0);
          faces.push_back({{a, b, c, -1}});
          faces.push_back({{a, c, d, -1}});
        }
    }
  return Cage::make("box of units", vertices, faces);
}

// On edges' extensions, before and behind them, and on diagonals of boxes.
std::vector<Vec3<double>> points_along_edges(const CageElements& elements, std::size_t stride) {
  std::vector<Vec3<double>> points;
  for (std::size_t e = 0; e < elements.count(); e += stride) {
    const auto c = elements.corners(e);
    for (const double share : {-1.0, -0.5, 0.5, 1.5, 2.0})
      for (std::size_t k = 0; k < c.size(); ++k)
        points.emplace_back((1 - share) * c[k] + share * c[(k + 1) % c.size()]);
  }
  return points;
}

std::vector<Touching> touching_by_walk(const CageElements& elements, const Vec3<double>& point) {
  std::vector<Touching> found;
  for (std::size_t e = 0; e < elements.count(); ++e) {
    const auto corners = elements.corners(e);
    const ContactPoint at = elements.type(e).contact(corners, point);
    if (at.contact != Contact::Off) found.push_back({static_cast<int>(e), at.basis});
  }
  return found;
}

// Every answer is that of a walk over all elements. \return how many points were on the cage, in it and outside
std::array<int, 3> expect_answers_of_walks(const Cage& cage, bool keeps_quads, const std::vector<Vec3<double>>& also) {
  const CageElements elements(cage, keeps_quads, Triangulation::Shortest);
  const WindingNumbers windings(elements);
  const auto triangles = all_triangles(CageElements(cage, false, Triangulation::Shortest));
  std::vector<Vec3<double>> points = asked_points(cage, 200);
  points.insert(points.end(), also.begin(), also.end());
  std::array<int, 3> counts{};
  for (const Vec3<double>& p : points) {
    const auto touching = elements.touching(p), walked = touching_by_walk(elements, p);
    EXPECT_EQ(touching.size(), walked.size()) << cage.name() << ' ' << p.transpose();
    for (std::size_t i = 0; i < std::min(touching.size(), walked.size()); ++i) {
      EXPECT_EQ(touching[i].element, walked[i].element) << cage.name() << ' ' << p.transpose();
      EXPECT_EQ(touching[i].basis, walked[i].basis) << cage.name() << ' ' << p.transpose();
    }
    const auto found = windings.around(p);
    EXPECT_EQ(found.has_value(), touching.empty()) << cage.name() << ' ' << p.transpose();
    if (!keeps_quads) {
      EXPECT_EQ(found, winding_number(triangles, p)) << cage.name() << ' ' << p.transpose();
    }
    ++counts[!found ? 0 : *found != 0 ? 1 : 2];
  }
  return counts;
}

TEST(winding_numbers, of_axis_parallel_faces_at_integer_points) {
  const Cage cage = box_of_units({4, 3, 2});
  std::vector<Vec3<double>> points;
  for (int x = -2; x <= 10; ++x)
    for (int y = -2; y <= 8; ++y)
      for (int z = -2; z <= 6; ++z) points.emplace_back(0.5 * x, 0.5 * y, 0.5 * z);
  const auto [on, in, out] = expect_answers_of_walks(cage, false, points);
  EXPECT_GE(in, 7 * 5 * 3);
  EXPECT_GE(on, 9 * 7 * 5 - 7 * 5 * 3);
  EXPECT_GE(out, 13 * 11 * 9 - 9 * 7 * 5);
}

TEST(winding_numbers, along_edges_and_beside_thin_walls) {
  for (const char* name : {"cube", "l-block", "spiky-box", "icosphere", "thin-wall-1e-3", "thin-wall-1e-12",
                           "wedge-1e-6", "crack-1e-8", "hollow-1e-9", "gap-1e-9", "nested", "fan"}) {
    const Cage cage = embedded_cage(name);
    const CageElements elements(cage, false, Triangulation::Shortest);
    std::vector<Vec3<double>> points = points_along_edges(elements, 1 + elements.count() / 40);
    // By the last bit off points of faces.
    for (std::size_t e = 0; e < elements.count(); e += 1 + elements.count() / 40) {
      const auto c = elements.corners(e);
      const Vec3<double> middle = 0.25 * c[0] + 0.25 * c[1] + 0.5 * c[2];
      for (int axis = 0; axis < 3; ++axis)
        for (const double towards : {-10.0, 10.0}) {
          Vec3<double> beside = middle;
          beside[axis] = std::nextafter(beside[axis], towards);
          points.push_back(beside);
        }
    }
    const auto [on, in, out] = expect_answers_of_walks(cage, false, points);
    EXPECT_TRUE(on > 0 && in > 0 && out > 0) << name << ' ' << on << ' ' << in << ' ' << out;
  }
}

TEST(winding_numbers, of_kept_quads_know_the_surface_as_contacts_do) {
  for (const char* name : {"cube", "twisted-bar", "l-block", "torus"}) {
    const Cage cage = embedded_cage(name);
    const CageElements elements(cage, true, Triangulation::Shortest);
    expect_answers_of_walks(cage, true, points_along_edges(elements, 1 + elements.count() / 20));
  }
}

// Corners of a sphere moved by random amounts, far from the origin and in another unit.
TEST(winding_numbers, of_random_surfaces_are_those_of_any_ray) {
  const Cage sphere = embedded_cage("icosphere");
  for (int trial = 0; trial < 6; ++trial) {
    std::vector<Vec3<double>> vertices = sphere.vertices();
    for (std::size_t v = 0; v < vertices.size(); ++v) {
      RandomStream random(11, "random surface", 1000 * trial + static_cast<int>(v));
      vertices[v] *= random.uniform(0.4, 1.6);
      if (trial % 2 == 1) vertices[v] = 1e-3 * vertices[v] + Vec3<double>(1e4, -3, 7);
    }
    const Cage cage = sphere.with(vertices, sphere.faces());
    const CageElements elements(cage, false, Triangulation::Shortest);
    const auto [on, in, out] = expect_answers_of_walks(cage, false, points_along_edges(elements, 7));
    EXPECT_TRUE(on > 0 && in > 0 && out > 0) << on << ' ' << in << ' ' << out;
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
}  // namespace cageproof::winding_numbers_test
