// SPDX-License-Identifier: MIT
#include "cageproof/reports/carried_mesh.h"

#include "cageproof/core/input_error.h"
#include "cageproof/reports/checked_file.h"

#include <gtest/gtest.h>
#include <vtkCellData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkXMLPolyDataReader.h>

#include <algorithm>

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

// A PLY of three vertices with colours and normals, a face with a quality, and an element that nobody knows.
std::string ply_with(const std::string& format, const std::string& body) {
  return "ply\r\nformat " + format +
         " 1.0\r\ncomment made by hand\r\nobj_info scan 7\r\nelement vertex 3\r\nproperty uchar red\r\n"
         "property float x\r\nproperty float y\r\nproperty float nx\r\nproperty float z\r\n"
         "property list uchar short tags\r\nelement face 1\r\nproperty list uchar int vertex_indices\r\n"
         "property float quality\r\nelement camera 1\r\nproperty double fov\r\nend_header\r\n" +
         body;
}

TEST(CarriedMesh, keeps_what_a_text_ply_has_beside_places) {
  const std::string header = ply_with("ascii", "");
  const CarriedMesh carried = ply_with_vertices(
      ply_with("ascii", "255 0 0 1 0 2 7 -8\n1 1 0 1 0 0\n2 0 1 1 0\n1 5\n3 0 1 2 0.5\n60\n"), kMoved);
  std::string expected = header;
  for (const std::string axis : {"x", "y", "z"})
    expected.replace(expected.find("property float " + axis), 16, "property double " + axis);
  expected.erase(expected.find("property float nx"), 19);
  EXPECT_EQ(carried.text, expected + "255 0.1 2 3 2 7 -8\n1 4 5 6 0\n2 7 8 -1e-17 1 5\n3 0 1 2 0.5\n60\n");
  EXPECT_EQ(carried.left_out, Words{"normals"});
}

template <class T>
std::string bytes(T value, bool big_endian) {
  std::string found(reinterpret_cast<const char*>(&value), sizeof value);
  if (big_endian) std::ranges::reverse(found);
  return found;
}

TEST(CarriedMesh, keeps_what_a_binary_ply_has_beside_places) {
  for (const bool big : {false, true}) {
    const std::string format = big ? "binary_big_endian" : "binary_little_endian";
    std::string before, after;
    for (int v = 0; v < 3; ++v) {
      const std::string colour(1, static_cast<char>(10 * v)), number = bytes(1.5F, big);
      std::string tags(1, static_cast<char>(v));
      for (int k = 0; k < v; ++k) tags += bytes(static_cast<short>(300 + k), big);
      before += colour + number + number + number + number + tags;
      after += colour + bytes(kMoved[v][0], big) + bytes(kMoved[v][1], big) + bytes(kMoved[v][2], big) + tags;
    }
    std::string rest(1, '\3');
    for (int k = 0; k < 3; ++k) rest += bytes(k, big);
    rest += bytes(0.25F, big) + bytes(60., big);
    const CarriedMesh carried = ply_with_vertices(ply_with(format, before + rest), kMoved);
    EXPECT_TRUE(carried.text.ends_with("end_header\r\n" + after + rest)) << format;
    EXPECT_THROW(ply_with_vertices(ply_with(format, before), kMoved), InputError);
  }
  EXPECT_THROW(ply_with_vertices(ply_with("ascii", "0 0 0 0 0 0"), std::span(kMoved).first(2)), InputError);
}

TEST(CarriedMesh, keeps_what_a_vtp_has_beside_places) {
  const std::string text =
      "<VTKFile type=\"PolyData\"><PolyData><Piece NumberOfPoints=\"3\" NumberOfVerts=\"0\" NumberOfLines=\"0\" "
      "NumberOfStrips=\"0\" NumberOfPolys=\"1\"><PointData Normals=\"up\"><DataArray type=\"Float32\" Name=\"heat\" "
      "format=\"ascii\">1 2 4</DataArray><DataArray type=\"Float32\" Name=\"up\" NumberOfComponents=\"3\" "
      "format=\"ascii\">0 0 1 0 0 1 0 0 1</DataArray></PointData><CellData><DataArray type=\"Int32\" Name=\"part\" "
      "format=\"ascii\">77</DataArray></CellData><Points><DataArray type=\"Float32\" NumberOfComponents=\"3\" "
      "format=\"ascii\">0 0 0 1 0 0 0 1 0</DataArray></Points><Polys><DataArray type=\"Int64\" Name=\"connectivity\" "
      "format=\"ascii\">0 1 2</DataArray><DataArray type=\"Int64\" Name=\"offsets\" format=\"ascii\">3</DataArray>"
      "</Polys></Piece></PolyData></VTKFile>";
  MeshField moved{"moved", kMoved, {{0, 1, 2}}, {{"image", "1", 1, {7, 8, 9}}}};
  const CarriedMesh carried = vtp_with_vertices(text, moved);
  EXPECT_EQ(carried.left_out, Words{"normals"});
  vtkNew<vtkXMLPolyDataReader> reader;
  reader->ReadFromInputStringOn();
  reader->SetInputString(carried.text);
  reader->Update();
  vtkPolyData& data = *reader->GetOutput();
  ASSERT_EQ(data.GetNumberOfPoints(), 3);
  for (int v = 0; v < 3; ++v) EXPECT_EQ(Vec3<double>(data.GetPoint(v)), kMoved[v]);
  EXPECT_EQ(data.GetNumberOfPolys(), 1);
  ASSERT_NE(data.GetPointData()->GetArray("heat"), nullptr);
  EXPECT_EQ(data.GetPointData()->GetArray("heat")->GetComponent(2, 0), 4);
  EXPECT_EQ(data.GetPointData()->GetArray("image [1]")->GetComponent(1, 0), 8);
  EXPECT_EQ(data.GetPointData()->GetArray("up"), nullptr);
  ASSERT_NE(data.GetCellData()->GetArray("part"), nullptr);
  EXPECT_EQ(data.GetCellData()->GetArray("part")->GetComponent(0, 0), 77);
  moved.vertices.pop_back();
  EXPECT_THROW(vtp_with_vertices(text, moved), InputError);
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
