// SPDX-License-Identifier: MIT
#include "cageproof/core/cage.h"

#include "cageproof/core/embedded_cages.h"
#include "support.h"

#include <cmath>
#include <limits>

namespace cageproof {
namespace {

using testing_support::expect_parts;
using testing_support::input_error_of;
using testing_support::volume;
using Vertices = std::vector<Vec3<double>>;
using Faces = std::vector<Face>;

const double kInfinity = std::numeric_limits<double>::infinity();
const Faces kTetrahedron{{{0, 2, 1, -1}}, {{0, 1, 3, -1}}, {{1, 2, 3, -1}}, {{0, 3, 2, -1}}};

Vertices tetrahedron_corners() { return {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}; }
Vertices cube_corners() { return embedded_cage("cube").vertices(); }
Faces cube_faces() { return embedded_cage("cube").faces(); }

Faces shifted(Faces faces, int by) {
  for (Face& face : faces)
    for (int k = 0; k < face.size(); ++k) face.vertices[k] += by;
  return faces;
}

Faces reversed(Faces faces) {
  for (Face& face : faces) std::reverse(face.vertices.begin(), face.vertices.begin() + face.size());
  return faces;
}

template <class T>
std::vector<T> joined(std::vector<T> a, const std::vector<T>& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

std::string error_of(Vertices vertices, Faces faces) {
  return input_error_of([&] { Cage::make("case", std::move(vertices), std::move(faces)); });
}

// A prism over a quad, its base first.
Cage prism(const std::array<std::pair<double, double>, 4>& base) {
  Vertices vertices;
  for (const double z : {0.0, 1.0})
    for (const auto& [x, y] : base) vertices.emplace_back(x, y, z);
  return Cage::make("prism", vertices,
                    {{{0, 3, 2, 1}}, {{4, 5, 6, 7}}, {{0, 1, 5, 4}}, {{1, 2, 6, 5}}, {{2, 3, 7, 6}}, {{3, 0, 4, 7}}});
}

TEST(cage_rejects, hole_names_face_and_edge) {
  Faces faces = cube_faces();
  faces.pop_back();
  expect_parts(error_of(cube_corners(), faces), {"case: ", "face 0", "edge between vertices 3 and 1", "hole"});
}

TEST(cage_rejects, edge_with_four_faces) {
  // Two tetrahedra that share the edge 0-1.
  const Vertices vertices{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, -1, 0}, {0, 0, -1}};
  const Faces second{{{0, 4, 1, -1}}, {{0, 1, 5, -1}}, {{1, 4, 5, -1}}, {{0, 5, 4, -1}}};
  expect_parts(error_of(vertices, joined(kTetrahedron, second)), {"face 0", "vertices 1 and 0", "4 faces", "manifold"});
}

TEST(cage_rejects, face_given_twice) {
  Faces faces = kTetrahedron;
  faces.push_back(faces[0]);
  expect_parts(error_of(tetrahedron_corners(), faces), {"face 0", "3 faces", "manifold"});
}

TEST(cage_rejects, one_face_turned_over) {
  Faces faces = cube_faces();
  faces[4] = reversed({faces[4]})[0];
  expect_parts(error_of(cube_corners(), faces), {"face 0", "the same way", "inconsistently"});
}

TEST(cage_rejects, inward_orientation_offers_the_option) {
  expect_parts(error_of(cube_corners(), reversed(cube_faces())), {"face 0", "inward", "--flip-inward"});
}

TEST(cage_rejects, bad_indices) {
  for (const int wrong : {8, -1, -7, 2147483647}) {
    Faces faces = cube_faces();
    faces[3].vertices[1] = wrong;
    expect_parts(error_of(cube_corners(), faces), {"face 3", std::to_string(wrong), "out of range"});
  }
  Faces faces = cube_faces();
  faces[2].vertices[3] = -2;
  expect_parts(error_of(cube_corners(), faces), {"face 2", "-2", "out of range"});
  faces = cube_faces();
  faces[5].vertices[3] = faces[5].vertices[1];
  expect_parts(error_of(cube_corners(), faces), {"face 5", "vertex 3 occurs twice"});
}

TEST(cage_rejects, unused_vertex) {
  Vertices vertices = cube_corners();
  vertices.emplace_back(9, 9, 9);
  expect_parts(error_of(vertices, cube_faces()), {"vertex 8", "no face"});
}

TEST(cage_rejects, nothing) {
  expect_parts(error_of({}, {}), {"no vertices"});
  expect_parts(error_of(cube_corners(), {}), {"no faces"});
}

TEST(cage_rejects, coordinates_that_are_not_finite) {
  for (const double wrong : {kInfinity, -kInfinity, std::nan("")}) {
    Vertices vertices = cube_corners();
    vertices[3][1] = wrong;
    expect_parts(error_of(vertices, cube_faces()), {"vertex 3", "not finite"});
  }
}

TEST(cage_rejects, triangle_without_area_in_any_unit) {
  for (const double unit : {1.0, 0.1, 1e-160, 1e150}) {
    Vertices vertices{{unit, unit, unit}, {2 * unit, 2 * unit, 2 * unit}, {4 * unit, 4 * unit, 4 * unit}, {0, unit, 0}};
    expect_parts(error_of(vertices, kTetrahedron), {"face 0", "degenerate", "lie on a line"});
  }
}

TEST(cage_rejects, edge_without_length) {
  Vertices vertices = cube_corners();
  vertices[5] = vertices[4];
  expect_parts(error_of(vertices, cube_faces()), {"face 1", "degenerate", "vertices 4 and 5 coincide"});
}

TEST(cage_rejects, quad_with_three_corners_on_a_line) {
  // The fan at corner 0 of the base would hold a triangle without area.
  expect_parts(input_error_of([] { prism({{{0, 0}, {1, 0}, {2, 0}, {1, 1}}}); }), {"face 0", "lie on a line"});
}

TEST(cage_rejects, quad_that_crosses_itself) {
  Faces faces = cube_faces();
  faces[2] = {{0, 1, 4, 5}};
  expect_parts(error_of(cube_corners(), faces), {"face 2", "bow-tie"});
}

TEST(cage_rejects, vertex_where_two_fans_meet) {
  const Vertices vertices = joined(tetrahedron_corners(), {{-1, 0, 0}, {0, -1, 0}, {0, 0, -1}});
  const Faces second = reversed({{{0, 5, 4, -1}}, {{0, 4, 6, -1}}, {{4, 5, 6, -1}}, {{0, 6, 5, -1}}});
  expect_parts(error_of(vertices, joined(kTetrahedron, second)), {"vertex 0", "more than one fan"});
}

TEST(cage_rejects, surface_without_volume) {
  expect_parts(error_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{{0, 1, 2, -1}}, {{0, 2, 1, -1}}}), {"no volume"});
  // A twisted quad against itself: each of its halves with the other's leaves a tetrahedron.
  expect_parts(error_of({{0, 0, 0}, {1, 0, 0.25}, {1, 1, 0}, {0, 1, 0.25}}, {{{0, 1, 2, 3}}, {{1, 0, 3, 2}}}),
               {"no volume"});
}

TEST(cage_accepts, any_unit_and_place) {
  for (const double unit : {1e-200, 1e-100, 1.0, 1e100, 1e150}) {
    Vertices vertices = cube_corners();
    for (auto& v : vertices) v *= unit;
    EXPECT_NEAR(Cage::make("cube", vertices, cube_faces()).size() / unit, std::sqrt(3.0), 1e-15) << unit;
  }
  Vertices vertices = cube_corners();
  for (auto& v : vertices) v += Vec3<double>(1e15, -1e15, 1e15);
  EXPECT_NO_THROW(Cage::make("cube", vertices, cube_faces()));
}

TEST(cage_accepts, triangle_one_ulp_away_from_a_line) {
  const double off = std::nextafter(1.0, 2.0);
  const Vertices vertices{{0, 0, 0}, {1, 1, 1}, {2, 2, 2 * off}, {0, 1, 0}};
  Faces faces = kTetrahedron;
  EXPECT_NO_THROW(Cage::make("needle", vertices, faces, {.flip_inward = true}));
}

TEST(cage_accepts, arrowhead_quad) { EXPECT_NEAR(volume(prism({{{0, 0}, {2, -1}, {1, 0}, {2, 1}}})), 1, 1e-15); }

TEST(cage_accepts, components_and_cavities) {
  Vertices inner = cube_corners(), far = cube_corners();
  for (auto& v : inner) v *= 0.5;
  for (auto& v : far) v += Vec3<double>(3, 0, 0);
  const Cage two = Cage::make("two", joined(cube_corners(), far), joined(cube_faces(), shifted(cube_faces(), 8)));
  EXPECT_DOUBLE_EQ(volume(two), 2);
  const Cage hollow =
      Cage::make("hollow", joined(cube_corners(), inner), joined(cube_faces(), shifted(reversed(cube_faces()), 8)));
  EXPECT_DOUBLE_EQ(volume(hollow), 0.875);
}

TEST(cage_flips, inward_cage_when_told) {
  const Cage cage = Cage::make("cube", cube_corners(), reversed(cube_faces()), {.flip_inward = true});
  EXPECT_DOUBLE_EQ(volume(cage), 1);
  for (std::size_t f = 0; f < cage.faces().size(); ++f)
    EXPECT_EQ(cage.faces()[f].vertices[0], reversed(cube_faces())[f].vertices[0]) << "the fan's corner stays";
  const Cage triangles =
      Cage::make("tetrahedron", tetrahedron_corners(), reversed(kTetrahedron), {.flip_inward = true});
  EXPECT_DOUBLE_EQ(volume(triangles), 1.0 / 6);
  EXPECT_FALSE(triangles.has_quads());
  EXPECT_EQ(triangles.faces()[0].size(), 3);
}

TEST(cage_flips, outward_cage_stays) {
  const Cage cage = Cage::make("cube", cube_corners(), cube_faces(), {.flip_inward = true});
  for (std::size_t f = 0; f < cage.faces().size(); ++f) EXPECT_EQ(cage.faces()[f].vertices, cube_faces()[f].vertices);
}

TEST(triangulation, shortest_takes_the_shorter_diagonal) {
  const Cage cage = prism({{{0, 0}, {1, 0}, {3, 1}, {0, 1}}});
  const auto base = [](const Cage::Triangles& t) { return std::array{t.triangles[0], t.triangles[1]}; };
  // The base is the face 0 3 2 1: its diagonals are 0-2 (10) and 3-1 (2).
  EXPECT_EQ(base(cage.triangulate(Triangulation::Shortest)), (std::array{std::array{3, 2, 1}, std::array{3, 1, 0}}));
  EXPECT_EQ(base(cage.triangulate(Triangulation::Fan)), (std::array{std::array{0, 3, 2}, std::array{0, 2, 1}}));
}

TEST(triangulation, ties_go_to_the_first_corner) {
  const Cage cage = embedded_cage("cube");
  EXPECT_EQ(cage.triangulate(Triangulation::Shortest).triangles, cage.triangulate(Triangulation::Fan).triangles);
}

TEST(triangulation, keeps_triangles_and_names_the_face) {
  const Cage cage = embedded_cage("l-block");
  const auto split = cage.triangulate(Triangulation::Shortest);
  std::vector<int> seen(cage.faces().size(), 0);
  for (const int face : split.face_of) ++seen[face];
  for (std::size_t f = 0; f < seen.size(); ++f) EXPECT_EQ(seen[f], cage.faces()[f].size() - 2);
  EXPECT_EQ(name_of(Triangulation::Shortest), "shortest");
  EXPECT_EQ(name_of(Triangulation::Fan), "fan");
}

}  // namespace
}  // namespace cageproof
