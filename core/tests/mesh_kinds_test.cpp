// SPDX-License-Identifier: MIT
// Behaviour that all mesh formats have in common.
#include "cageproof/core/cage/mesh_io.h"

#include "support.h"

namespace cageproof {
namespace {

using testing_support::expect_parts;
using testing_support::input_error_of;
using testing_support::TemporaryFolder;

TEST(mesh_formats, name_a_pointer_of_git_lfs) {
  const TemporaryFolder folder;
  for (const char* name : {"p.obj", "p.ply", "p.stl", "p.off", "p.vtp", "p.svg", "p.geojson", "p.csv"})
    expect_parts(
        input_error_of([&] {
          read_points(folder.write(name, "version https://git-lfs.github.com/spec/v1\noid sha256:0\nsize 1\n"));
        }),
        {name, "a Git LFS pointer, not the file", "git lfs pull"});
}

TEST(mesh_formats, name_a_first_line_that_is_not_theirs) {
  const TemporaryFolder folder;
  for (const char* name : {"p.obj", "p.ply", "p.stl", "p.off"})
    expect_parts(input_error_of([&] { read_mesh(folder.write(name, "kind of file\n")); }),
                 {std::string(name) + ":1: ", "\"kind\""});
}

TEST(mesh_formats, make_consecutive_equal_corners_one) {
  const TemporaryFolder folder;
  const std::string ply =
      "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\nelement face 4\n"
      "property list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n";
  const std::string faces = "4 0 2 1 1\n4 0 0 1 3\n4 1 2 3 1\n5 0 3 2 2 0\n";
  const std::string vtp = R"(<?xml version="1.0"?>
<VTKFile type="PolyData" version="0.1" byte_order="LittleEndian"><PolyData>
<Piece NumberOfPoints="4" NumberOfVerts="0" NumberOfLines="0" NumberOfStrips="0" NumberOfPolys="4">
<Points><DataArray type="Float64" NumberOfComponents="3" format="ascii">0 0 0 1 0 0 0 1 0 0 0 1</DataArray></Points>
<Polys><DataArray type="Int64" Name="connectivity" format="ascii">0 2 1 1 0 0 1 3 1 2 3 1 0 3 2 2 0</DataArray>
<DataArray type="Int64" Name="offsets" format="ascii">4 8 12 17</DataArray></Polys></Piece></PolyData></VTKFile>
)";
  for (const auto& [name, text] :
       {std::pair<const char*, std::string>{
            "r.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2 2\nf 1 1 2 4\nf 2 3 4 2\nf 1 4 3 3 1\n"},
        {"r.off", "OFF\n4 4 6\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n" + faces},
        {"r.ply", ply + faces},
        {"r.vtp", vtp}}) {
    const auto path = folder.write(name, text);
    EXPECT_EQ(read_mesh(path).faces, (std::vector<std::vector<int>>{{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}}))
        << name;
    EXPECT_FALSE(read_cage(path).has_quads()) << name;
  }
  const auto flat = folder.write("flat.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 2\n");
  expect_parts(input_error_of([&] { read_cage(flat); }), {"flat.obj: face 0 (line 5)", "twice"});
}

TEST(mesh_formats, extensions_in_any_case) {
  EXPECT_EQ(extension_of("folder.X/Name.Y.PlY"), ".ply");
  EXPECT_EQ(extension_of("name"), "");
}

}  // namespace
}  // namespace cageproof
