// SPDX-License-Identifier: MIT
// Meshes and energies as text: what is written is read again, and is what it was.
#include "cageproof/reports/energy_history.h"
#include "cageproof/reports/mesh_text.h"

#include "cageproof/core/cage/mesh_io.h"
#include "cageproof/core/input_error.h"
#include "cageproof/reports/checked_file.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <filesystem>

namespace cageproof::reports {
namespace {

namespace fs = std::filesystem;

Mesh read_again(const char* name, const std::string& text) {
  const fs::path file = fs::path(testing::TempDir()) / name;
  write_file(file, text);
  Mesh mesh = read_mesh(file);
  fs::remove(file);
  return mesh;
}

const Mesh& mesh_of_all_digits() {
  static const Mesh mesh = [] {
    Mesh made;
    made.vertices = {{0.1, -1.0 / 3, 1e-17}, {2.0 / 3, 1e10 / 7, 0}, {0.3, 0.7, 0.9}, {1, 1, 1}, {-1, 0.2, 5}};
    made.faces = {{0, 1, 2, 3}, {0, 2, 4}};
    return made;
  }();
  return mesh;
}

TEST(MeshText, obj_keeps_every_digit_and_quads) {
  const Mesh &mesh = mesh_of_all_digits(), again = read_again("all.obj", obj_text(mesh));
  EXPECT_EQ(again.vertices, mesh.vertices);
  EXPECT_EQ(again.faces, mesh.faces);
}

TEST(MeshText, obj_keeps_polylines) {
  Mesh mesh;
  mesh.vertices = {{0, 0, 0}, {0.1, 0, 0}, {0, 0.3, 0}};
  mesh.segments = {{0, 1}, {1, 2}, {2, 0}};
  const Mesh again = read_again("lines.obj", obj_text(mesh));
  EXPECT_EQ(again.vertices, mesh.vertices);
  EXPECT_EQ(again.segments, mesh.segments);
}

TEST(MeshText, ply_keeps_every_digit_and_quads) {
  const Mesh &mesh = mesh_of_all_digits(), again = read_again("all.ply", ply_text(mesh));
  EXPECT_EQ(again.vertices, mesh.vertices);
  EXPECT_EQ(again.faces, mesh.faces);
  EXPECT_EQ(read_again("points.ply", ply_text({mesh.vertices, {}})).vertices, mesh.vertices);
}

using Corner = std::array<float, 3>;

// A binary STL's triangle: its normal and its corners.
std::array<Corner, 4> triangle_in(const std::string& stl, std::size_t index) {
  std::array<Corner, 4> found{};
  std::memcpy(found.data(), stl.data() + 84 + 50 * index, sizeof found);
  return found;
}

TEST(StlText, gives_the_surface_back) {
  Mesh mesh;
  mesh.vertices = {{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {0, 1, 0}, {0, 0, 3}};
  mesh.faces = {{0, 1, 4}, {0, 4, 3}, {1, 2, 4}, {2, 3, 4}, {3, 2, 1}, {0, 3, 1}};
  const PartialMeshText stl = stl_text(mesh);
  EXPECT_EQ(stl.text.size(), 84U + 50 * 6);
  EXPECT_TRUE(stl.left_out.empty());
  EXPECT_TRUE(stl.changed.empty());
  EXPECT_EQ(triangle_in(stl.text, 0), (std::array<Corner, 4>{{{0, -1, 0}, {0, 0, 0}, {2, 0, 0}, {0, 0, 3}}}));
  const Mesh again = read_again("surface.stl", stl.text);
  ASSERT_EQ(again.faces.size(), mesh.faces.size());
  EXPECT_EQ(again.vertices.size(), mesh.vertices.size());
  for (std::size_t f = 0; f < mesh.faces.size(); ++f)
    for (std::size_t k = 0; k < 3; ++k)
      EXPECT_EQ(again.vertices[again.faces[f][k]], mesh.vertices[mesh.faces[f][k]]) << f << ' ' << k;
}

TEST(StlText, cuts_faces_as_cages_are_cut) {
  Mesh mesh;
  // A quad whose shorter diagonal is 1-3, an arrowhead whose shorter diagonal lies outside, and an L.
  mesh.vertices = {{0, 0, 0},  {2, 1, 0}, {4, 0, 0}, {2, -1, 0}, {0, 9, 0}, {0, 5, 0}, {3, 4, 0}, {0, 8, 0},
                   {-3, 4, 0}, {0, 0, 5}, {2, 0, 5}, {2, 1, 5},  {1, 1, 5}, {1, 2, 5}, {0, 2, 5}};
  mesh.faces = {{0, 3, 2, 1}, {5, 6, 7, 8}, {9, 10, 11, 12, 13, 14}};
  const PartialMeshText stl = stl_text(mesh);
  EXPECT_EQ(stl.text.size(), 84U + 50 * (2 + 2 + 4));
  EXPECT_EQ(stl.left_out, std::vector<std::string>{"1 vertices of no face"});
  const Mesh again = read_again("cut.stl", stl.text);
  double area = 0;
  for (std::size_t f = 0; f < again.faces.size(); ++f) {
    const std::vector<int>& t = again.faces[f];
    const Vec3<double> normal =
        (again.vertices[t[1]] - again.vertices[t[0]]).cross(again.vertices[t[2]] - again.vertices[t[0]]);
    EXPECT_GT(normal[2], 0) << "triangle " << f << " is turned";
    EXPECT_EQ(triangle_in(stl.text, f)[0], (Corner{0, 0, 1}));
    area += normal[2] / 2;
  }
  // Triangles that are all turned as their faces, and have their area, cover them.
  EXPECT_EQ(area, 4 + 9 + 3);
  for (std::size_t f = 0; f < 2; ++f) {
    const std::array<Corner, 4> t = triangle_in(stl.text, f);
    EXPECT_EQ(
        std::count(t.begin() + 1, t.end(), Corner{2, 1, 0}) + std::count(t.begin() + 1, t.end(), Corner{2, -1, 0}), 2)
        << "the longer diagonal";
  }
}

TEST(StlText, says_what_is_otherwise) {
  Mesh mesh;
  mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0.1, 1, 0}, {1, 1, 0}};
  mesh.faces = {{0, 1, 2}, {0, 4, 1, 2, 3}};
  mesh.segments = {{0, 1}};
  const PartialMeshText stl = stl_text(mesh);
  EXPECT_EQ(triangle_in(stl.text, 0)[0], (Corner{0, 0, 0})) << "a triangle without area has no normal";
  EXPECT_EQ(triangle_in(stl.text, 3)[3], (Corner{0.1F, 1, 0}));
  EXPECT_EQ(stl.left_out, std::vector<std::string>{"polylines"});
  ASSERT_EQ(stl.changed.size(), 2U);
  EXPECT_NE(stl.changed[0].find("single precision"), std::string::npos);
  EXPECT_NE(stl.changed[1].find("face 1 "), std::string::npos);
}

TEST(StlText, refuses_what_stl_cannot_hold) {
  const auto reason_of = [](const Mesh& mesh) -> std::string {
    try {
      stl_text(mesh);
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_NE(reason_of({{{0, 0, 0}}, {}}).find("no faces"), std::string::npos);
  const std::string beyond = reason_of({{{0, 0, 0}, {1, 0, 0}, {0, -1e39, 0}}, {{0, 1, 2}}});
  EXPECT_NE(beyond.find("vertex 2 "), std::string::npos) << beyond;
  EXPECT_NE(beyond.find("-1e+39"), std::string::npos) << beyond;
  EXPECT_EQ(reason_of({{{0, 0, 0}, {1, 0, 0}, {0, 3.4e38, 0}, {0, 1e39, 0}}, {{0, 1, 2}}}), "");
}

TEST(SvgText, gives_vertices_and_segments_back) {
  Mesh mesh;
  mesh.vertices = {{0.1, -1.0 / 3, 0},
                   {1e22 / 7, 5e-324, 0},
                   {-2.0 / 3, 1e-17, 0},
                   {7, 7, 0},
                   {0, 0, 0},
                   {3, 1, 0},
                   {3, 2, 0},
                   {4, 2, 0},
                   {5, 0, 0},
                   {6, 0, 0}};
  // A closed polyline, a vertex without segments, an open one, and there and back.
  mesh.segments = {{0, 1}, {1, 2}, {2, 0}, {4, 5}, {5, 6}, {6, 7}, {8, 9}, {9, 8}};
  const PartialMeshText svg = svg_text(mesh);
  EXPECT_TRUE(svg.left_out.empty());
  EXPECT_TRUE(svg.changed.empty());
  const Mesh again = read_again("all.svg", svg.text);
  EXPECT_EQ(again.vertices, mesh.vertices);
  EXPECT_EQ(again.segments, mesh.segments);
}

TEST(SvgText, puts_pieces_of_polylines_together) {
  Mesh mesh;
  mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {5, 5, 0}, {6, 5, 0}, {7, 5, 0}};
  // A square in any order, one segment against the others, and an open line that begins in the middle.
  mesh.segments = {{2, 3}, {0, 1}, {2, 1}, {3, 0}, {5, 6}, {4, 5}};
  const PartialMeshText svg = svg_text(mesh);
  EXPECT_NE(svg.text.find("<path d=\"M0,0 L1,0 L1,-1 L0,-1 Z\"/>\n<path d=\"M5,-5 L6,-5 L7,-5\"/>\n"),
            std::string::npos)
      << svg.text;
  EXPECT_TRUE(svg.changed.empty());
}

TEST(SvgText, holds_everything_in_its_view_box) {
  Mesh mesh;
  mesh.vertices = {{-3, 10, 0}, {5, -2, 0}, {0, 4, 0}};
  mesh.segments = {{0, 1}, {1, 2}};
  const std::string text = svg_text(mesh).text;
  double left = 0, top = 0, width = 0, height = 0;
  ASSERT_EQ(
      std::sscanf(text.c_str() + text.find("viewBox"), "viewBox=\"%lf %lf %lf %lf\"", &left, &top, &width, &height), 4);
  EXPECT_LT(left, -3);
  EXPECT_GT(left + width, 5);
  EXPECT_LT(top, -10);
  EXPECT_GT(top + height, 2);
}

TEST(SvgText, says_what_is_otherwise) {
  Mesh mesh;
  mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  mesh.segments = {{0, 2}, {2, 1}, {1, 0}, {1, 1}};
  mesh.faces = {{0, 1, 2}};
  const PartialMeshText turned = svg_text(mesh);
  EXPECT_EQ(turned.left_out, (std::vector<std::string>{"faces", "segments from a vertex to itself"}));
  ASSERT_EQ(turned.changed.size(), 1U);
  EXPECT_NE(turned.changed[0].find("order of their polylines"), std::string::npos);
  // Three lines from one vertex.
  mesh.vertices.emplace_back(2, 2, 0);
  mesh.segments = {{0, 1}, {0, 2}, {0, 3}};
  const PartialMeshText star = svg_text(mesh);
  ASSERT_EQ(star.changed.size(), 1U);
  EXPECT_NE(star.changed[0].find("share"), std::string::npos);
  EXPECT_EQ(read_again("star.svg", star.text).segments.size(), 3U);
  // Ends that the map has laid on each other.
  mesh.vertices[3] = mesh.vertices[0];
  mesh.segments = {{0, 1}, {1, 2}, {2, 3}};
  const PartialMeshText joined = svg_text(mesh);
  ASSERT_EQ(joined.changed.size(), 1U);
  EXPECT_NE(joined.changed[0].find("1 polylines begin and end at one place"), std::string::npos);
  EXPECT_EQ(read_again("joined.svg", joined.text).vertices.size(), 3U);
  EXPECT_THROW(svg_text({mesh.vertices, {}}), InputError);
  mesh.vertices[1][0] = 1.7e308;
  mesh.vertices[2][0] = -1.7e308;
  EXPECT_THROW(svg_text(mesh), InputError);
}

TEST(EnergyHistory, is_numbered_and_whole) {
  const std::vector<double> energies{0.1, 1.0 / 3, 0};
  EXPECT_EQ(energies_csv(energies), "number,energy\n1,0.1\n2,0.3333333333333333\n3,0\n");
  EXPECT_TRUE(energies_png(energies, "it's a title").starts_with("\x89PNG"));
}

}  // namespace
}  // namespace cageproof::reports
