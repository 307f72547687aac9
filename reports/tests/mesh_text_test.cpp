// SPDX-License-Identifier: MIT
// Meshes and energies as text: what is written is read again, and is what it was.
#include "cageproof/reports/energy_history.h"
#include "cageproof/reports/mesh_text.h"

#include "cageproof/core/cage/mesh_io.h"
#include "cageproof/reports/checked_file.h"

#include <gtest/gtest.h>

#include <cmath>
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

TEST(EnergyHistory, is_numbered_and_whole) {
  const std::vector<double> energies{0.1, 1.0 / 3, 0};
  EXPECT_EQ(energies_csv(energies), "number,energy\n1,0.1\n2,0.3333333333333333\n3,0\n");
  EXPECT_TRUE(energies_png(energies, "it's a title").starts_with("\x89PNG"));
}

}  // namespace
}  // namespace cageproof::reports
