// SPDX-License-Identifier: MIT
// Contents of meshes whose volumes and areas are known, and meshes that are open.
#include "cageproof/core/cage/enclosed.h"
#include "cageproof/core/cage/mesh_io.h"
#include "cageproof/core/numbers/random_stream.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>

namespace cageproof {
namespace {

using Vec = Vec3<double>;

// A box of those half edges somewhere, of quads that point outward.
Mesh box(const Vec& half, const Vec& middle) {
  Mesh mesh;
  for (int v = 0; v < 8; ++v)
    mesh.vertices.emplace_back(middle + half.cwiseProduct(Vec(v & 1 ? 1 : -1, v & 2 ? 1 : -1, v & 4 ? 1 : -1)));
  mesh.faces = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
  return mesh;
}

double content(const Mesh& mesh, int dimension, const ContentUnit& unit = {}) {
  return content_of({mesh.faces, mesh.segments, dimension}, mesh.vertices, unit).value;
}

bool is_closed(const Mesh& mesh, int dimension = 3) {
  return cageproof::is_closed({mesh.faces, mesh.segments, dimension});
}

TEST(Enclosed, a_box_holds_six_simplices_a_cube_wherever_it_is) {
  const Mesh mesh = box({1, 2, 0.5}, {30, -20, 7});
  EXPECT_DOUBLE_EQ(content(mesh, 3), 6 * 8);
  EXPECT_DOUBLE_EQ(content(mesh, 3, {.length = 2}), 6);
  EXPECT_DOUBLE_EQ(content(mesh, 3, {.simplices = 6}), 8);
  EXPECT_TRUE(is_closed(mesh));
}

TEST(Enclosed, a_bilinear_quad_holds_the_same_wherever_its_corners_begin) {
  Mesh mesh = box({.5, .5, .5}, {.5, .5, .5});
  mesh.vertices[7] += Vec(0, 0, 1);
  // The top is z = 1 + x y, whose integral over the square is 5/4; the sides stay planar.
  for (int turns = 0; turns < 4; ++turns) {
    EXPECT_DOUBLE_EQ(content(mesh, 3, {.simplices = 6}), 1.25) << turns;
    for (auto& face : mesh.faces) std::ranges::rotate(face, face.begin() + 1);
  }
}

// Faces of few vertices at random, in pairs that are turned over or not, against counts of directed edges.
TEST(Enclosed, is_closed_where_every_edge_is_run_along_as_often_both_ways) {
  std::array<int, 2> seen{};
  for (int trial = 0; trial < 400; ++trial) {
    RandomStream random(12, "faces", trial);
    Mesh mesh;
    for (int f = 0; f < 1 + trial % 5; ++f) {
      std::vector<int> face(3 + trial % 3);
      for (int& v : face) v = random.below(6);
      mesh.faces.push_back(face);
      std::ranges::reverse(face);
      if (random.below(8) != 0) mesh.faces.push_back(face);
    }
    std::map<std::pair<int, int>, int> ways;
    for (const auto& face : mesh.faces)
      for (std::size_t k = 0; k < face.size(); ++k) ++ways[{face[k], face[(k + 1) % face.size()]}];
    const bool expected = std::ranges::all_of(ways, [&](const auto& way) {
      const auto other = ways.find({way.first.second, way.first.first});
      return other != ways.end() && other->second == way.second;
    });
    EXPECT_EQ(is_closed(mesh), expected) << trial;
    ++seen[expected ? 1 : 0];
  }
  EXPECT_GT(seen[0], 20);
  EXPECT_GT(seen[1], 20);
  EXPECT_TRUE(is_closed(Mesh()));
}

TEST(Enclosed, parts_that_cancel_have_no_known_content) {
  const auto is_known = [](const Mesh& mesh) {
    return content_of({mesh.faces, mesh.segments, 3}, mesh.vertices, {}).is_known();
  };
  Mesh mesh = box({.1, .2, .3}, {.3, .7, .1});
  EXPECT_TRUE(is_known(mesh));
  const Mesh other = box({.1, .2, .3}, {5, 1.1, -2.3});
  mesh.vertices.insert(mesh.vertices.end(), other.vertices.begin(), other.vertices.end());
  for (auto face : other.faces) {
    std::ranges::reverse(face);
    for (int& v : face) v += 8;
    mesh.faces.push_back(face);
  }
  EXPECT_TRUE(is_closed(mesh));
  EXPECT_FALSE(is_known(mesh));
  EXPECT_FALSE(is_known({}));
}

TEST(Enclosed, what_is_inside_out_is_negative) {
  Mesh mesh = box({1, 1, 1}, {0, 0, 0});
  for (auto& face : mesh.faces) std::swap(face[1], face[3]);
  EXPECT_DOUBLE_EQ(content(mesh, 3), -48);
  EXPECT_TRUE(is_closed(mesh));
}

TEST(Enclosed, the_plane_has_areas_of_faces_and_of_segments) {
  // An L of two faces, and its border.
  const std::vector<Vec> corners{{5, 1, 0}, {7, 1, 0}, {7, 2, 0}, {6, 2, 0}, {6, 3, 0}, {5, 3, 0}};
  Mesh faces{corners, {{0, 1, 2, 3}, {0, 3, 4, 5}}}, border{corners, {}};
  for (int k = 0; k < 6; ++k) border.segments.push_back({k, (k + 1) % 6});
  for (const Mesh* mesh : {&faces, &border}) {
    EXPECT_DOUBLE_EQ(content(*mesh, 2), 2 * 3);
    EXPECT_DOUBLE_EQ(content(*mesh, 2, {.length = 10, .simplices = 2}), 0.03);
  }
  EXPECT_FALSE(is_closed(faces, 2));
  EXPECT_TRUE(is_closed(border, 2));
}

TEST(Enclosed, a_missing_or_turned_face_or_segment_opens_a_mesh) {
  Mesh missing = box({1, 1, 1}, {0, 0, 0}), turned = missing, doubled = missing;
  missing.faces.pop_back();
  std::swap(turned.faces[3][0], turned.faces[3][2]);
  doubled.faces.push_back(doubled.faces[2]);
  for (const Mesh* mesh : {&missing, &turned, &doubled}) EXPECT_FALSE(is_closed(*mesh));
  Mesh line{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {}};
  line.segments = {{0, 1}, {1, 2}};
  EXPECT_FALSE(is_closed(line, 2));
  line.segments.push_back({2, 0});
  EXPECT_TRUE(is_closed(line, 2));
  line.segments.back() = {0, 2};
  EXPECT_FALSE(is_closed(line, 2));
}

TEST(Enclosed, lines_in_space_enclose_nothing_and_open_nothing) {
  Mesh mesh = box({1, 1, 1}, {0, 0, 0});
  mesh.segments = {{0, 1}, {1, 3}, {3, 0}, {4, 5}};
  EXPECT_DOUBLE_EQ(content(mesh, 3), 48);
  EXPECT_TRUE(is_closed(mesh));
}

}  // namespace
}  // namespace cageproof
