// SPDX-License-Identifier: MIT
#include "cageproof/core/cage/cage.h"

#include "cageproof/core/cage/embedded_cages.h"
#include "cage/face_crossings.h"
#include "cageproof/core/input_error.h"
#include "support.h"

#include <algorithm>
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

TEST(cage_rejects, edge_with_four_faces_of_which_three_run_one_way) {
  const Vertices vertices{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, -1, 0}, {0, 0, -1}};
  Faces second{{{0, 4, 1, -1}}, {{0, 1, 5, -1}}, {{1, 4, 5, -1}}, {{0, 5, 4, -1}}};
  second[0] = reversed({second[0]})[0];
  expect_parts(error_of(vertices, joined(kTetrahedron, second)),
               {"face 0", "vertices 1 and 0", "4 faces", "of which 1 run", "3 the other", "manifold"});
}

TEST(cage_rejects, face_given_twice) {
  Faces faces = kTetrahedron;
  faces.push_back(faces[0]);
  expect_parts(error_of(tetrahedron_corners(), faces), {"face 4", "the vertices of face 0", "twice"});
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

// Between three points on a line and three that are next to it is a sign, whatever the exponents are.
TEST(cage_accepts, triangles_as_thin_as_doubles_can_be) {
  for (const double thin : {1e-90, 1e-110, 1e-300, 5e-324})
    EXPECT_NO_THROW(Cage::make("thin", Vertices{{thin, 0, 0}, {2, 2, 0}, {1, 1, 0}, {0, 0, 1}}, kTetrahedron)) << thin;
  expect_parts(error_of({{0, 0, 0}, {2, 2, 0}, {1, 1, 0}, {0, 0, 1}}, kTetrahedron), {"face 0", "lie on a line"});
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

// Triangles beside quads, in every order of faces and from every corner of each.
TEST(cage_accepts, triangles_and_quads_together) {
  struct Solid {
    Vertices vertices;
    Faces faces;
    double volume;
  };
  const std::vector<Solid> solids{
      {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {0, 1, 1}},  // a prism over a triangle
       {{{0, 2, 1, -1}}, {{3, 4, 5, -1}}, {{0, 1, 4, 3}}, {{1, 2, 5, 4}}, {{2, 0, 3, 5}}},
       .5},
      {{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {.5, .5, 3}},  // a pyramid over a square
       {{{0, 3, 2, 1}}, {{0, 1, 4, -1}}, {{1, 2, 4, -1}}, {{2, 3, 4, -1}}, {{3, 0, 4, -1}}},
       1},
      {{{0, 0, 0},
        {1, 0, 0},
        {1, 1, 0},
        {0, 1, 0},
        {0, 0, 1},
        {1, 0, 1},
        {1, 1, 1},
        {0, 1, 1},
        {.5, .5, 2.5}},  // a house
       {{{0, 3, 2, 1}},
        {{0, 1, 5, 4}},
        {{1, 2, 6, 5}},
        {{2, 3, 7, 6}},
        {{3, 0, 4, 7}},
        {{4, 5, 8, -1}},
        {{5, 6, 8, -1}},
        {{6, 7, 8, -1}},
        {{7, 4, 8, -1}}},
       1.5},
  };
  for (const Solid& solid : solids) {
    Faces faces = solid.faces;
    for (std::size_t turn = 0; turn < 12; ++turn) {
      std::ranges::rotate(faces, faces.begin() + 1);
      auto& first = faces.front().vertices;
      std::rotate(first.begin(), first.begin() + 1, first.begin() + faces.front().size());
      EXPECT_NEAR(volume(Cage::make("solid", solid.vertices, faces)), solid.volume, 1e-15) << turn;
      EXPECT_NEAR(volume(Cage::make("solid", solid.vertices, reversed(faces), {.flip_inward = true})), solid.volume,
                  1e-15)
          << turn;
    }
  }
}

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

// Cubes of these half widths about the origin, each inside the one before.
Cage nested(const std::vector<std::pair<double, bool>>& widths_and_inward, const CageOptions& options = {}) {
  Vertices vertices;
  Faces faces;
  for (const auto& [width, inward] : widths_and_inward) {
    Vertices corners = cube_corners();
    for (auto& v : corners) v *= width;
    faces = joined(faces, shifted(inward ? reversed(cube_faces()) : cube_faces(), static_cast<int>(vertices.size())));
    vertices = joined(vertices, corners);
  }
  return Cage::make("nested", vertices, faces, options);
}

TEST(cage_parts, shells_and_cavities_alternate) {
  EXPECT_DOUBLE_EQ(volume(nested({{4, false}, {3, true}, {2, false}, {1, true}})), 64 - 27 + 8 - 1);
  // In whatever order they come.
  EXPECT_DOUBLE_EQ(volume(nested({{1, true}, {3, true}, {4, false}, {2, false}})), 64 - 27 + 8 - 1);
}

TEST(cage_parts, nested_shells_of_equal_orientation_are_named) {
  const std::string message = input_error_of([] { nested({{2, false}, {1, false}}); });
  expect_parts(message, {"nested: the part of 6 faces from face 6 on", "within 1 other part", "from face 0 on",
                         "bounds a cavity", "--flip-inward"});
  expect_parts(input_error_of([] {
                 nested({{1, false}, {2, false}});
               }),
               {"from face 0 on lies within", "from face 6 on"});
  expect_parts(input_error_of([] {
                 nested({{3, false}, {2, true}, {1, true}});
               }),
               {"6 faces from face 12 on", "within 2 other parts", "bounds no cavity"});
}

TEST(cage_parts, an_inverted_part_beside_another_is_named) {
  Vertices far = cube_corners();
  for (auto& v : far) v += Vec3<double>(3, 0, 0);
  const Vertices vertices = joined(cube_corners(), far);
  expect_parts(error_of(vertices, joined(cube_faces(), shifted(reversed(cube_faces()), 8))),
               {"case: the part of 6 faces from face 6 on", "within no other part", "bounds no cavity", "inward"});
  // Half of its volume less than nothing does not hide it.
  for (auto& v : far) v = 0.25 * (v - Vec3<double>(3, 0, 0)) + Vec3<double>(3, 0, 0);
  expect_parts(error_of(joined(cube_corners(), far), joined(reversed(cube_faces()), shifted(cube_faces(), 8))),
               {"from face 0 on", "inward"});
}

TEST(cage_parts, are_turned_when_told) {
  EXPECT_DOUBLE_EQ(volume(nested({{2, false}, {1, false}}, {.flip_inward = true})), 7);
  EXPECT_DOUBLE_EQ(volume(nested({{2, true}, {1, false}}, {.flip_inward = true})), 7);
  EXPECT_DOUBLE_EQ(volume(nested({{2, false}, {1, true}}, {.flip_inward = true})), 7);
}

TEST(cage_parts, without_volume_are_named) {
  const Vertices flat{{5, 0, 0}, {6, 0, 0}, {5, 1, 0}};
  expect_parts(error_of(joined(cube_corners(), flat), joined(cube_faces(), Faces{{{8, 9, 10, -1}}, {{8, 10, 9, -1}}})),
               {"part of 2 faces from face 6 on", "no volume"});
}

TEST(cage_parts, any_unit) {
  for (const double unit : {1e-150, 1e-30, 1e30, 1e140}) {
    EXPECT_NO_THROW(nested({{2 * unit, false}, {unit, true}})) << unit;
    EXPECT_THROW(nested({{2 * unit, false}, {unit, false}}), InputError) << unit;
    EXPECT_FALSE(crossing_warning(nested({{2 * unit, false}, {unit, true}}))) << unit;
  }
}

TEST(cage_parts, that_touch_or_cross_lie_beside_each_other) {
  const auto moved = [](double x, double scale, bool inward) {
    Vertices other = cube_corners();
    for (auto& v : other) v = scale * v + Vec3<double>(x, 0, 0);
    return Cage::make("two", joined(cube_corners(), other),
                      joined(cube_faces(), shifted(inward ? reversed(cube_faces()) : cube_faces(), 8)));
  };
  // A cavity whose side lies in the shell's is within it all the same.
  EXPECT_TRUE(crossing_warning(moved(0.25, 0.5, true)));
  EXPECT_THROW(moved(0.25, 0.5, false), InputError);
  EXPECT_TRUE(crossing_warning(moved(1, 1, false)));
  EXPECT_TRUE(crossing_warning(moved(0.5, 0.5, false)));
  EXPECT_THROW(moved(0.5, 0.5, true), InputError);
  EXPECT_TRUE(crossing_warning(moved(0, 1, false))) << "the same surface twice";
  EXPECT_FALSE(crossing_warning(moved(1.0625, 1, false)));
}

TEST(polygon_parts, holes_run_clockwise) {
  const auto squares = [](const std::vector<std::pair<double, bool>>& widths_and_clockwise) {
    Vertices vertices;
    Faces segments;
    for (const auto& [width, clockwise] : widths_and_clockwise) {
      const int first = static_cast<int>(vertices.size());
      for (const auto& [x, y] : {std::pair{-1.0, -1.0}, {1.0, -1.0}, {1.0, 1.0}, {-1.0, 1.0}})
        vertices.emplace_back(width * x, width * y, 0);
      for (int k = 0; k < 4; ++k) {
        const int from = first + k, to = first + (k + 1) % 4;
        segments.push_back({{clockwise ? to : from, clockwise ? from : to, -1, -1}});
      }
    }
    return Cage::make_polygon("squares", vertices, segments);
  };
  EXPECT_NO_THROW(squares({{2, false}, {1, true}}));
  EXPECT_NO_THROW(squares({{1, true}, {3, false}, {0.5, false}}));
  expect_parts(input_error_of([&] {
                 squares({{2, false}, {1, false}});
               }),
               {"part of 4 segments from segment 4 on", "within 1 other"});
  expect_parts(input_error_of([&] { squares({{1, true}}); }), {"clockwise", "segment 0", "--flip-inward"});
}

TEST(crossing_faces, are_named_by_number) {
  // A double pyramid whose top, vertex 4, was pushed through one of its lower faces.
  const auto pyramid = [](const Vec3<double>& top) {
    Faces faces;
    for (int k = 0; k < 4; ++k) faces.push_back({{k, (k + 1) % 4, 4, -1}});
    for (int k = 0; k < 4; ++k) faces.push_back({{(k + 1) % 4, k, 5, -1}});
    return Cage::make("pyramid", {{1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}, top, {0, 0, -1}}, faces);
  };
  EXPECT_TRUE(crossing_faces(pyramid({0.25, 0.25, -0.25})).empty());
  const Cage cage = pyramid({0.25, 0.25, -0.75});
  EXPECT_EQ(crossing_faces(cage), (std::vector<std::string>{"faces 1 and 4", "faces 2 and 4", "faces 3 and 4"}));
  EXPECT_NE(crossing_warning(cage).value().find("pyramid: faces 1 and 4, faces 2 and 4"), std::string::npos);
  // Just touching; now its own upper face lies in the lower one.
  EXPECT_EQ(crossing_faces(pyramid({0.25, 0.25, -0.5})).size(), 4u);
}

// A triangle over a quad's diagonal, which is no edge of it: from whichever corner the quad is written.
TEST(crossing_faces, do_not_depend_on_where_a_quad_begins) {
  for (const double twist : {0., .25}) {
    const Vertices vertices{{0, 0, 0}, {1, 0, twist}, {1, 1, 0}, {0, 1, twist}, {.5, .5, 1}};
    for (int turn = 0; turn < 4; ++turn) {
      Face quad{{0, 1, 2, 3}};
      std::ranges::rotate(quad.vertices, quad.vertices.begin() + turn);
      const auto found = face_crossings(vertices, {quad, Face{{0, 2, 4, -1}}});
      ASSERT_EQ(found.size(), 1u) << turn;
    }
  }
}

TEST(crossing_faces, are_none_where_a_reflex_corner_is) {
  EXPECT_TRUE(crossing_faces(prism({{{0, 0}, {2, -1}, {1, 0}, {2, 1}}})).empty());
  for (const auto name : embedded_cage_names()) EXPECT_FALSE(crossing_warning(embedded_cage(name))) << name;
}

TEST(crossing_faces, lie_between_a_twisted_quads_diagonals) {
  // Above its centre the quad's two triangles are at height 0 by one diagonal, at 1 by the other.
  const std::vector<Vec3<double>> quad{{0, 0, 0}, {2, 0, 1}, {2, 2, 0}, {0, 2, 1}};
  const auto crossed_at = [&](double height) {
    std::vector<Vec3<double>> vertices = quad;
    vertices.emplace_back(1, 1, height - 0.125);
    vertices.emplace_back(1.0625, 1, height + 0.125);
    vertices.emplace_back(1, 1.0625, height + 0.125);
    return face_crossings(vertices, {{{0, 1, 2, 3}}, {{4, 5, 6, -1}}});
  };
  const std::vector<FaceCrossing> both{{0, 1}};
  EXPECT_EQ(crossed_at(0), both);
  EXPECT_EQ(crossed_at(1), both);
  EXPECT_TRUE(crossed_at(-0.5).empty());
  EXPECT_TRUE(crossed_at(1.5).empty());
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

// The concave corner is each of the four in turn, so that the diagonal outside is the shorter one and, for two of them,
// that of the first corner.
TEST(triangulation, takes_the_diagonal_inside_a_concave_quad) {
  constexpr std::array<std::pair<double, double>, 4> arrowhead{{{0, 0}, {0.5, 2}, {0, 1.5}, {-0.5, 2}}};
  for (std::size_t first = 0; first < 4; ++first) {
    std::array<std::pair<double, double>, 4> base;
    for (std::size_t k = 0; k < 4; ++k) base[k] = arrowhead[(k + first) % 4];
    const Cage cage = prism(base);
    for (const Triangulation rule : {Triangulation::Shortest, Triangulation::Fan}) {
      const Cage::Triangles split = cage.triangulate(rule);
      for (std::size_t t = 0; t < split.triangles.size(); ++t) {
        const auto corner = [&](int k) { return cage.vertices()[split.triangles[t][k]]; };
        const Vec3<double> normal = (corner(1) - corner(0)).cross(corner(2) - corner(0));
        const auto& face = cage.faces()[split.face_of[t]].vertices;
        const auto at = [&](int k) { return cage.vertices()[face[k]]; };
        // As the face's area vector.
        EXPECT_GT(normal.dot((at(2) - at(0)).cross(at(3) - at(1))), 0) << first << ' ' << name_of(rule) << ' ' << t;
      }
    }
    EXPECT_FALSE(folding_warning(cage));
  }
}

TEST(triangulation, says_which_quads_fold_along_either_diagonal) {
  // A bow-tie, one wing larger than the other, as base and top.
  std::vector<Vec3<double>> vertices;
  for (const double z : {0.0, 1.0})
    for (const auto& [x, y] : {std::array{0.0, 0.0}, {2.0, 0.0}, {0.0, 1.0}, {1.0, 2.0}}) vertices.push_back({x, y, z});
  CageOptions options{.flip_inward = true, .allow_invalid_quads = true, .face_lines = {9, 10, 11, 12, 13, 14}};
  const auto warning = [&]() -> std::optional<std::string> {
    try {
      return folding_warning(Cage::make(
          "bow-tie", vertices,
          {{{0, 3, 2, 1}}, {{4, 5, 6, 7}}, {{0, 1, 5, 4}}, {{1, 2, 6, 5}}, {{2, 3, 7, 6}}, {{3, 0, 4, 7}}}, options));
    } catch (const InputError& error) {
      return error.what();
    }
  }();
  ASSERT_TRUE(warning);
  EXPECT_NE(warning->find("face 0 (line 9)"), std::string::npos) << *warning;
}

// One end of a diagonal of length 1 is raised by a height whose square no number of a few hundred digits holds
// beside 1.
TEST(triangulation, tells_diagonals_apart_however_alike_they_are) {
  for (const double height : {1e-10, 1e-60, 1e-200, 5e-324}) {
    const Cage cage = Cage::make(
        "roof",
        {{0, 0, 0}, {.5, -.5, .25}, {1, 0, height}, {.5, .5, .25}, {0, 0, -1}, {.5, -.5, -1}, {1, 0, -1}, {.5, .5, -1}},
        {{{0, 1, 2, 3}}, {{4, 7, 6, 5}}, {{0, 4, 5, 1}}, {{1, 5, 6, 2}}, {{2, 6, 7, 3}}, {{3, 7, 4, 0}}});
    const auto triangles = cage.triangulate(Triangulation::Shortest).triangles;
    for (int i = 0; i < 2; ++i)
      for (const int corner : {1, 3}) EXPECT_TRUE(std::ranges::count(triangles[i], corner)) << height << ' ' << corner;
  }
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
