// SPDX-License-Identifier: MIT
// Meshes and energies as text: what is written is read again, and is what it was.
#include "cageproof/reports/energy_history.h"
#include "cageproof/reports/mesh_text.h"

#include "cageproof/core/cage/mesh_io.h"
#include "cageproof/core/input_error.h"
#include "cageproof/reports/checked_file.h"

#include <gtest/gtest.h>

#include <cmath>
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

std::string refusal_of(std::string (*text)(const Mesh&), const Mesh& mesh) {
  try {
    text(mesh);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(MeshText, stl_is_read_as_the_same_triangles_in_single_precision) {
  Mesh mesh;
  mesh.vertices = {{0.1, 0, 0}, {1, 0, 0}, {0, 1, 1e-30}, {0, 0, 0.7}};
  mesh.faces = {{0, 1, 2}, {0, 3, 1}};
  const std::string text = stl_text(mesh);
  ASSERT_EQ(text.size(), 84 + 2 * 50U);
  const Mesh again = read_again("two.stl", text);
  ASSERT_EQ(again.faces.size(), 2U);
  for (std::size_t f = 0; f < 2; ++f)
    for (std::size_t k = 0; k < 3; ++k)
      EXPECT_EQ(again.vertices[again.faces[f][k]],
                Vec3<double>(mesh.vertices[mesh.faces[f][k]].cast<float>().cast<double>()));
  // The first normal is along z, but for the 1e-30.
  float normal[3];
  std::memcpy(normal, text.data() + 84, sizeof normal);
  EXPECT_EQ(normal[2], 1.0F);
  EXPECT_LT(std::abs(normal[0]), 1e-29F);
  // A triangle without area has none.
  mesh.faces = {{0, 1, 1}};
  std::memcpy(normal, stl_text(mesh).data() + 84, sizeof normal);
  for (const float x : normal) EXPECT_EQ(x, 0.0F);
}

TEST(MeshText, stl_refuses_what_it_cannot_hold) {
  EXPECT_NE(refusal_of(stl_text, mesh_of_all_digits()).find("face 0 has 4 corners"), std::string::npos);
  EXPECT_NE(refusal_of(stl_text, {{{0, 0, 0}}, {}}).find("no faces"), std::string::npos);
  const Mesh far{{{0, 0, 0}, {1, 0, 0}, {0, 1e39, 0}}, {{0, 1, 2}}};
  EXPECT_NE(refusal_of(stl_text, far).find("vertex 2: 1e+39"), std::string::npos);
}

TEST(MeshText, svg_is_read_as_the_same_polygons) {
  Mesh mesh;
  mesh.vertices = {{0.1, -1.0 / 3, 0}, {2.0 / 3, 0, 0}, {1e-17, 7, 0}, {3, 3, 0}, {4, 3, 0}, {3.5, 1e10 / 7, 0}};
  mesh.segments = {{0, 1}, {1, 2}, {2, 0}, {3, 4}, {4, 5}, {5, 3}};
  const Mesh again = read_again("two.svg", svg_text(mesh));
  EXPECT_EQ(again.vertices, mesh.vertices);
  EXPECT_EQ(again.segments, mesh.segments);
}

TEST(MeshText, svg_refuses_what_it_cannot_hold) {
  EXPECT_NE(refusal_of(svg_text, mesh_of_all_digits()).find("no polylines"), std::string::npos);
  Mesh mesh{{{0, 0, 0}, {1, 0, 0}, {0, 1, 1}, {5, 5, 0}}, {}};
  mesh.segments = {{0, 1}, {1, 2}, {2, 0}};
  EXPECT_NE(refusal_of(svg_text, mesh).find("vertex 2: z is 1"), std::string::npos);
  mesh.vertices[2][2] = 0;
  EXPECT_NE(refusal_of(svg_text, mesh).find("vertex 3 belongs to no polyline"), std::string::npos);
}

TEST(EnergyHistory, is_numbered_and_whole) {
  const std::vector<double> energies{0.1, 1.0 / 3, 0};
  EXPECT_EQ(energies_csv(energies), "number,energy\n1,0.1\n2,0.3333333333333333\n3,0\n");
  EXPECT_TRUE(energies_png(energies, "it's a title").starts_with("\x89PNG"));
}

}  // namespace
}  // namespace cageproof::reports
