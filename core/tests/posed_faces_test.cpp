// SPDX-License-Identifier: MIT
#include "cageproof/core/cage/posed_faces.h"

#include "cageproof/core/cage/embedded_cages.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace cageproof::posed_faces_test {
namespace {

Mesh mesh_of(const Cage& cage) {
  Mesh mesh{cage.vertices(), {}};
  for (const Face& face : cage.faces()) {
    if (cage.dimension() == 2) mesh.segments.push_back({face.vertices[0], face.vertices[1]});
    else mesh.faces.emplace_back(face.vertices.begin(), face.vertices.begin() + face.size());
  }
  return mesh;
}

TEST(PosedFaces, are_the_rest_cages_from_any_corner) {
  const Cage cage = embedded_cage("cube");
  Mesh mesh = mesh_of(cage);
  EXPECT_FALSE(foreign_face(cage, mesh));
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
    std::ranges::rotate(mesh.faces[f], mesh.faces[f].begin() + static_cast<int>(f % mesh.faces[f].size()));
    if (f % 2 == 1) std::ranges::reverse(mesh.faces[f]);
  }
  EXPECT_FALSE(foreign_face(cage, mesh));
  EXPECT_FALSE(foreign_face(cage, {cage.vertices(), {}}));
}

TEST(PosedFaces, may_be_triangles_of_quads_and_quads_of_triangles) {
  const Cage quads =
      Cage::make("box", {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}},
                 {{{0, 3, 2, 1}}, {{4, 5, 6, 7}}, {{0, 1, 5, 4}}, {{1, 2, 6, 5}}, {{2, 3, 7, 6}}, {{3, 0, 4, 7}}});
  Mesh split{quads.vertices(), {}};
  std::vector<Face> triangles;
  for (const auto& t : quads.triangulate(Triangulation::Fan).triangles) {
    split.faces.push_back({t[0], t[1], t[2]});
    triangles.push_back({{t[0], t[1], t[2], -1}});
  }
  EXPECT_FALSE(foreign_face(quads, split));
  EXPECT_FALSE(foreign_face(Cage::make("split", quads.vertices(), triangles), mesh_of(quads)));
}

TEST(PosedFaces, may_be_polygons_that_the_cage_cut_in_triangles) {
  Mesh prism{{{2, 0, 0},
              {1, 2, 0},
              {-1, 2, 0},
              {-2, 0, 0},
              {0, -2, 0},
              {2, 0, 1},
              {1, 2, 1},
              {-1, 2, 1},
              {-2, 0, 1},
              {0, -2, 1}},
             {{4, 3, 2, 1, 0}, {5, 6, 7, 8, 9}, {0, 1, 6, 5}, {1, 2, 7, 6}, {2, 3, 8, 7}, {3, 4, 9, 8}, {4, 0, 5, 9}}};
  const Cage cage = cage_from(prism, "prism.obj");
  EXPECT_FALSE(foreign_face(cage, prism));
  std::swap(prism.faces[0][0], prism.faces[1][0]);
  EXPECT_TRUE(foreign_face(cage, prism));
}

TEST(PosedFaces, name_the_first_that_another_numbering_makes) {
  const Cage cage = embedded_cage("cube");
  Mesh mesh = mesh_of(cage);
  // Vertices 0 and 6 change their numbers.
  for (std::vector<int>& face : mesh.faces)
    for (int& v : face) v = v == 0 ? 6 : v == 6 ? 0 : v;
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) mesh.face_lines.push_back(20 + f);
  const auto found = foreign_face(cage, mesh);
  ASSERT_TRUE(found);
  EXPECT_NE(found->find("(line 2"), std::string::npos) << *found;
  EXPECT_NE(found->find("no face of cube"), std::string::npos) << *found;
}

// Turned by a quarter about an axis a box has the same faces.
TEST(PosedFaces, name_the_first_that_a_symmetric_numbering_moves) {
  const std::vector<std::vector<int>> faces{{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4},
                                            {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}};
  std::vector<Face> of_cage;
  of_cage.reserve(faces.size());
  for (const auto& f : faces) of_cage.push_back({{f[0], f[1], f[2], f[3]}});
  const Cage cage = Cage::make(
      "box", {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}}, of_cage);
  Mesh mesh{cage.vertices(), faces};
  for (std::vector<int>& face : mesh.faces)
    for (int& v : face) v = v < 4 ? (v + 1) % 4 : 4 + (v + 1) % 4;
  const auto found = foreign_face(cage, mesh);
  ASSERT_TRUE(found);
  EXPECT_EQ(*found, "face 2 joins vertices 1, 2, 6, 5, and face 2 of box joins 0, 1, 5, 4");
}

TEST(PosedFaces, are_segments_in_the_plane) {
  const Cage cage = embedded_cage("square");
  Mesh mesh = mesh_of(cage);
  EXPECT_FALSE(foreign_face(cage, mesh));
  mesh.segments[0] = {0, 2};
  const auto found = foreign_face(cage, mesh);
  ASSERT_TRUE(found);
  EXPECT_TRUE(found->starts_with("segment 0 joins vertices 0, 2")) << *found;
}

}  // namespace
}  // namespace cageproof::posed_faces_test
