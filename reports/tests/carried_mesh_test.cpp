// SPDX-License-Identifier: MIT
#include "cageproof/reports/carried_mesh.h"

#include "cageproof/core/input_error.h"
#include "cageproof/reports/checked_file.h"

#include <gtest/gtest.h>

namespace cageproof::reports {
namespace {

using Words = std::vector<std::string>;

const std::vector<Vec3<double>> kMoved{{0.1, 2, 3}, {4, 5, 6}, {7, 8, -1e-17}};

TEST(CarriedMesh, keeps_what_an_obj_has_beside_places) {
  const std::string text =
      "# a mesh\r\nmtllib paint.mtl\r\no body\r\nv 0 0 0 # first\r\nv 1 0 0 0.5 0.25 1\r\nv 0 1 \\\r\n 0 2\r\n"
      "vt 0 0\r\nvt 1 0\r\nvn 0 0 1\r\ng front\r\nusemtl red\r\ns 1\r\nf 1/1 2/2 3/1\r\n";
  const CarriedMesh carried = obj_with_vertices(text, kMoved);
  EXPECT_EQ(carried.text,
            "# a mesh\r\nmtllib paint.mtl\r\no body\r\nv 0.1 2 3 # first\r\nv 4 5 6 0.5 0.25 1\r\nv 7 8 -1e-17\r\n"
            "vt 0 0\r\nvt 1 0\r\ng front\r\nusemtl red\r\ns 1\r\nf 1/1 2/2 3/1\r\n");
  EXPECT_EQ(carried.left_out, Words{"normals"});
}

TEST(CarriedMesh, takes_normals_from_an_objs_faces) {
  const std::string text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvn 0 0 1\nf 1/1/1 2/1/1 3/1/1 # both\nf 1//1 2//1 3//-1";
  EXPECT_EQ(obj_with_vertices(text, kMoved).text,
            "v 0.1 2 3\nv 4 5 6\nv 7 8 -1e-17\nvt 0 0\nf 1/1 2/1 3/1 # both\nf 1 2 3");
  EXPECT_TRUE(obj_with_vertices("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", kMoved).left_out.empty());
}

TEST(CarriedMesh, refuses_another_number_of_vertices) {
  EXPECT_THROW(obj_with_vertices("v 0 0 0\n", kMoved), InputError);
  EXPECT_THROW(obj_with_vertices("v 0 0 0\nv 0 0 0\nv 0 0 0\nv 0 0 0\n", kMoved), InputError);
}

TEST(CarriedMesh, names_what_another_format_leaves_out) {
  const auto of = [](const char* name, const std::string& text) {
    const auto file = std::filesystem::path(testing::TempDir()) / name;
    write_file(file, text);
    Words found = beside_places(file);
    std::filesystem::remove(file);
    return found;
  };
  EXPECT_EQ(of("all.OBJ", "v 0 0 0 1 1 1\nvt 0 0\nvn 0 0 1\no a\ng b\nusemtl c\nmtllib d\ns 1\nf 1 1 1\n"),
            (Words{"vertex colours", "texture coordinates", "normals", "objects", "groups", "materials",
                   "smoothing groups"}));
  EXPECT_TRUE(of("plain.obj", "# vt\nv 0 0 0\n").empty());
  EXPECT_EQ(of("some.ply",
               "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\nproperty float z\n"
               "property uchar red\nelement face 0\nproperty list uchar int vertex_indices\nelement camera 0\n"
               "property float fov\nend_header\nproperty red\n"),
            (Words{"property red", "element camera"}));
  EXPECT_EQ(of("some.vtp", "<DataArray type=\"Float64\" Name=\"Points\"><DataArray Name=\"heat\" format=\"ascii\">"),
            Words{"array heat"});
  EXPECT_TRUE(of("points.csv", "0,0,0\n").empty());
}

}  // namespace
}  // namespace cageproof::reports
