// SPDX-License-Identifier: MIT
// Real cages and meshes ([T18]'s data set), where they lie beside the project; generated files prove the same
// elsewhere.
#include "cageproof/core/cage/mesh_io.h"

#include "support.h"

namespace cageproof {
namespace {

struct Model {
  std::string name;
  std::size_t cage_vertices, cage_faces, mesh_vertices, mesh_faces;
};

TEST(shared_data, real_cages_and_meshes_read_whole) {
  const std::filesystem::path folder = CAGEPROOF_SHARED_DATA;
  if (!std::filesystem::exists(folder)) GTEST_SKIP() << "the data are not next to the project";
  for (const Model& m : {Model{"Bench", 24, 22, 65430, 65406}, Model{"FireHydrant", 48, 46, 39028, 76444},
                         Model{"SpikyBox", 8, 6, 60802, 60800}, Model{"WireSphere", 8, 6, 48964, 49152}}) {
    const Cage cage = read_cage(folder / (m.name + "_Cage.obj"));
    EXPECT_EQ(cage.vertices().size(), m.cage_vertices) << m.name;
    EXPECT_EQ(cage.faces().size(), m.cage_faces) << m.name;
    EXPECT_TRUE(cage.has_quads()) << m.name;
    EXPECT_GT(testing_support::volume(cage), 0) << m.name;
    // Deformed cages may cross themselves, and stay cages.
    EXPECT_EQ(read_cage(folder / (m.name + "_Cage_Deformed.obj")).faces().size(), m.cage_faces) << m.name;
    const auto path = folder / (m.name + ".obj");
    const Mesh mesh = read_mesh(path);
    EXPECT_EQ(mesh.vertices.size(), m.mesh_vertices) << path;
    EXPECT_EQ(mesh.faces.size(), m.mesh_faces) << path;
    EXPECT_EQ(read_points(path).size(), m.mesh_vertices) << path;
  }
}

}  // namespace
}  // namespace cageproof
