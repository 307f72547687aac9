// SPDX-License-Identifier: MIT
// Cages of what files hold that is not yet triangles and quads, or polylines.
#include "support.h"

#include "cageproof/core/cage/merged_vertices.h"
#include "cageproof/core/cage/mesh_io.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

namespace cageproof {
namespace {

using namespace testing_support;

constexpr const char* kName = "cage.obj";

// A prism on a regular polygon, of quads and two polygons.
Mesh prism(int sides) {
  Mesh mesh;
  for (const double z : {0.0, 1.0})
    for (int k = 0; k < sides; ++k) {
      const double angle = 2 * M_PI * k / sides;
      mesh.vertices.emplace_back(std::cos(angle), std::sin(angle), z);
    }
  std::vector<int> base, top;
  for (int k = 0; k < sides; ++k) {
    base.insert(base.begin(), k);
    top.push_back(sides + k);
    const int next = (k + 1) % sides;
    mesh.faces.push_back({k, next, sides + next, sides + k});
  }
  mesh.faces.push_back(base);
  mesh.faces.push_back(top);
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) mesh.face_lines.push_back(10 + f);
  return mesh;
}

TEST(CageFrom, knows_faces_by_the_numbers_of_the_file) {
  Mesh mesh = prism(6);
  // The polygons first.
  std::ranges::rotate(mesh.faces, mesh.faces.end() - 2);
  const Cage cage = cage_from(mesh, kName);
  ASSERT_EQ(cage.faces().size(), 14U);
  for (std::size_t f = 0; f < 14; ++f)
    EXPECT_EQ(cage.face_number(f), f < 8 ? static_cast<int>(f) / 4 : static_cast<int>(f) - 6) << f;
  // The last face of the file is a hole's neighbour.
  mesh.faces.pop_back();
  expect_parts(input_error_of([&] { cage_from(mesh, kName); }), {"face 0 (line 10)", "hole"});
  std::ranges::reverse(mesh.faces.back());
  mesh.faces.push_back(prism(6).faces[5]);
  expect_parts(input_error_of([&] { cage_from(mesh, kName); }), {"face 0 (line 10)", "inconsistently"});
  // Faces that vanish leave their numbers behind.
  Mesh apart = prism(4);
  apart.faces.insert(apart.faces.begin(), {0, 1, 1});
  apart.face_lines.clear();
  EXPECT_EQ(cage_from(merged(apart, merging_of(apart.vertices, 0), kName), kName).face_number(0), 1);
}

std::string error_of(Mesh mesh) {
  return input_error_of([&] { cage_from(std::move(mesh), kName); });
}

TEST(CageFrom, cuts_faces_of_more_than_four_corners) {
  for (const int sides : {5, 6, 11}) {
    const Mesh mesh = as_cage_mesh(prism(sides), kName);
    EXPECT_EQ(mesh.faces.size(), static_cast<std::size_t>(sides + 2 * (sides - 2)));
    ASSERT_EQ(mesh.warnings.size(), 1U);
    EXPECT_EQ(mesh.warnings[0],
              fmt::format("cage.obj: 2 faces of more than 4 corners are cut in triangles, the first of them face {} "
                          "(line {})",
                          sides, 10 + sides));
    const Cage cage = cage_from(prism(sides), kName);
    EXPECT_EQ(cage.face_lines().back(), static_cast<std::size_t>(11 + sides));
  }
  EXPECT_TRUE(as_cage_mesh(prism(4), kName).warnings.empty());
}

TEST(CageFrom, names_a_polygon_that_crosses_itself) {
  Mesh mesh = prism(6);
  std::swap(mesh.faces[6][1], mesh.faces[6][4]);
  expect_parts(error_of(mesh), {"cage.obj: ", "face 6 (line 16)", "6 corners", "crosses"});
}

// Two triangles, of which one has the square's other corner, and a hole in a ring of quads.
TEST(CageFrom, takes_a_flat_mesh_for_the_polygon_of_its_boundary) {
  Mesh square{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 3}}, {5, 6}};
  for (const bool turned : {false, true}) {
    if (turned)
      for (auto& face : square.faces) std::swap(face[1], face[2]);
    const Cage cage = cage_from(square, kName);
    EXPECT_EQ(cage.dimension(), 2);
    EXPECT_EQ(cage.faces().size(), 4U);
    EXPECT_EQ(as_cage_mesh(square, kName).warnings.size(), 1U);
  }
  Mesh ring{{{0, 0, 0}, {3, 0, 0}, {3, 3, 0}, {0, 3, 0}, {1, 1, 0}, {2, 1, 0}, {2, 2, 0}, {1, 2, 0}},
            {{0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}}};
  EXPECT_EQ(cage_from(ring, kName).faces().size(), 8U);
}

TEST(CageFrom, names_what_keeps_a_flat_mesh_from_being_a_polygon) {
  Mesh fan{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0.5, 0.5, 0}}, {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}}};
  expect_parts(error_of(fan), {"cage.obj: ", "vertex 4", "within a flat mesh", "`l` lines"});
  Mesh turned{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 3, 2}}, {5, 6}};
  expect_parts(error_of(turned), {"cage.obj: ", "face 1 (line 6)", "turned differently"});
}

TEST(CageFrom, names_vertices_in_one_place_where_faces_do_not_share_them) {
  Mesh mesh = prism(4), apart;
  for (const auto& face : mesh.faces) {
    std::vector<int> own;
    for (const int v : face) {
      own.push_back(static_cast<int>(apart.vertices.size()));
      apart.vertices.push_back(mesh.vertices[v]);
    }
    apart.faces.push_back(own);
  }
  expect_parts(error_of(apart), {"face 0", "belongs to no other face", "lie in one place, and so do 15 more", "weld"});
}

}  // namespace
}  // namespace cageproof
