// SPDX-License-Identifier: MIT
#include "cageproof/reports/carried_mesh.h"

#include "cageproof/core/cage/mesh_io.h"
#include "cageproof/core/input_error.h"
#include "cageproof/reports/checked_file.h"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkFloatArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkStringArray.h>
#include <vtkUnsignedCharArray.h>
#include <vtkXMLPolyDataReader.h>
#include <vtkXMLPolyDataWriter.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

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

TEST(CarriedMesh, keeps_what_a_text_ply_has_beside_places) {
  const std::string text =
      "ply\r\nformat ascii 1.0\r\ncomment TextureFile skin.png\r\nobj_info scanned\r\nelement camera 1\r\n"
      "property list uchar float view\r\nelement vertex 3\r\nproperty uchar red\r\nproperty float x\r\n"
      "property float32 y\r\nproperty float nx\r\nproperty double z\r\nproperty list uchar int near\r\n"
      "property float ny\r\nproperty float nz\r\nelement face 1\r\nproperty list uchar int vertex_indices\r\n"
      "property uchar flags\r\nend_header\r\n2 .5 1e3\r\n10 0 0 1 0 1 2 0 0 20 1 0 0\r\n0 0 1 0 30 0 1 0 0 2 0 1 1 "
      "0\r\n"
      "3 0 1 2 7\r\n";
  const CarriedMesh carried = ply_with_vertices(text, kMoved);
  EXPECT_EQ(carried.text,
            "ply\r\nformat ascii 1.0\r\ncomment TextureFile skin.png\r\nobj_info scanned\r\nelement camera 1\r\n"
            "property list uchar float view\r\nelement vertex 3\r\nproperty uchar red\r\nproperty double x\r\n"
            "property double y\r\nproperty double z\r\nproperty list uchar int near\r\nelement face 1\r\n"
            "property list uchar int vertex_indices\r\nproperty uchar flags\r\nend_header\r\n2 .5 1e3\r\n"
            "10 0.1 2 3 1 2\r\n20 4 5 6 0\r\n30 7 8 -1e-17 2 0 1\r\n3 0 1 2 7\r\n");
  EXPECT_EQ(carried.left_out, Words{"normals"});
}

// Bytes of numbers, in the order that is asked for.
template <class... Numbers>
std::string bytes_of(bool big_endian, Numbers... numbers) {
  std::string all;
  const auto add = [&](auto x) {
    auto bytes = std::bit_cast<std::array<char, sizeof x>>(x);
    if (big_endian) std::ranges::reverse(bytes);
    all.append(bytes.data(), bytes.size());
  };
  (add(numbers), ...);
  return all;
}

TEST(CarriedMesh, keeps_the_bytes_of_a_binary_ply) {
  for (const bool big : {false, true}) {
    const std::string format =
        fmt::format("ply\nformat binary_{}_endian 1.0\nelement vertex 3\n", big ? "big" : "little");
    const std::string behind =
        "property uchar red\nproperty list ushort short near\nelement face 1\n"
        "property list int uint vertex_index\nproperty double weight\n";
    const auto byte = [](int x) { return static_cast<std::uint8_t>(x); };
    const auto word = [](int x) { return static_cast<std::uint16_t>(x); };
    std::string text = fmt::format(
        "{}property float x\nproperty float y\nproperty float z\nproperty float nz\n{}property float nx\nend_header\n",
        format, behind);
    std::string wanted =
        fmt::format("{}property double x\nproperty double y\nproperty double z\n{}end_header\n", format, behind);
    for (int i = 0; i < 3; ++i) {
      const std::string kept = bytes_of(big, byte(10 + i), word(2), word(513), word(7 * i));
      text += bytes_of(big, 1.0F * static_cast<float>(i), 0.0F, 0.0F, 1.0F) + kept;
      wanted += bytes_of(big, kMoved[i][0], kMoved[i][1], kMoved[i][2]) + kept;
    }
    const std::string face = bytes_of(big, 3, 0, 1, 2, 0.1);
    text += face + bytes_of(big, 1.0F) + "more";
    wanted += face;
    const CarriedMesh carried = ply_with_vertices(text, kMoved);
    EXPECT_EQ(carried.text, wanted);
    EXPECT_EQ(carried.left_out, Words{"normals"});
    EXPECT_THROW(ply_with_vertices(text.substr(0, wanted.size() - 30), kMoved), InputError);
  }
}

TEST(CarriedMesh, refuses_a_ply_with_another_number_of_vertices) {
  EXPECT_THROW(ply_with_vertices("ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\n"
                                 "property float z\nend_header\n0 0 0\n",
                                 kMoved),
               InputError);
}

// A triangle, a vertex cell and a line with arrays, and one of them infinite.
vtkSmartPointer<vtkPolyData> poly_with_arrays() {
  auto data = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  for (int i = 0; i < 3; ++i) points->InsertNextPoint(i, i == 1, 0);
  data->SetPoints(points);
  vtkNew<vtkCellArray> verts, lines, polys;
  const std::array<vtkIdType, 3> corners{0, 1, 2};
  verts->InsertNextCell(1, corners.data());
  lines->InsertNextCell(2, corners.data());
  polys->InsertNextCell(3, corners.data());
  data->SetVerts(verts);
  data->SetLines(lines);
  data->SetPolys(polys);
  const auto array = [](auto made, const char* name, int components) {
    made->SetName(name);
    made->SetNumberOfComponents(components);
    made->SetNumberOfTuples(3);
    for (int k = 0; k < 3 * components; ++k) made->SetComponent(k / components, k % components, k + 1);
    return made;
  };
  const auto velocity = array(vtkSmartPointer<vtkFloatArray>::New(), "velocity", 3);
  velocity->SetValue(4, std::numeric_limits<float>::infinity());
  data->GetPointData()->AddArray(velocity);
  data->GetPointData()->SetNormals(array(vtkSmartPointer<vtkFloatArray>::New(), "of points", 3));
  data->GetPointData()->AddArray(array(vtkSmartPointer<vtkDoubleArray>::New(), "image [1]", 3));
  data->GetCellData()->SetScalars(array(vtkSmartPointer<vtkUnsignedCharArray>::New(), "part", 1));
  data->GetCellData()->AddArray(array(vtkSmartPointer<vtkFloatArray>::New(), "Normals", 3));
  vtkNew<vtkStringArray> title;
  title->SetName("title");
  title->InsertNextValue("a mesh");
  data->GetFieldData()->AddArray(title);
  return data;
}

TEST(CarriedMesh, keeps_the_arrays_of_a_vtp) {
  const auto file = std::filesystem::path(testing::TempDir()) / "carried.vtp";
  {
    vtkNew<vtkXMLPolyDataWriter> writer;
    const auto data = poly_with_arrays();
    writer->SetInputData(data);
    writer->SetFileName(file.c_str());
    ASSERT_TRUE(writer->Write());
  }
  MeshField images{"images", kMoved, {}, {}, {}};
  images.arrays.push_back({"image", "1", 3, {1, 2, 3, 4, 5, 6, 7, 8, 9.5}});
  const CarriedMesh carried = vtp_with_vertices(file, kMoved, images);
  EXPECT_EQ(carried.left_out, Words{"normals"});
  EXPECT_EQ(carried.replaced, Words{"array image [1]"});
  EXPECT_THROW(vtp_with_vertices(file, std::span(kMoved).first(2), images), InputError);
  write_file(file, carried.text);
  EXPECT_EQ(read_mesh(file).vertices, kMoved);
  vtkNew<vtkXMLPolyDataReader> reader;
  reader->SetFileName(file.c_str());
  reader->Update();
  vtkPolyData& again = *reader->GetOutput();
  std::filesystem::remove(file);
  EXPECT_EQ(again.GetNumberOfVerts(), 1);
  EXPECT_EQ(again.GetNumberOfLines(), 1);
  EXPECT_EQ(again.GetNumberOfPolys(), 1);
  ASSERT_EQ(again.GetPointData()->GetNumberOfArrays(), 2);
  auto* const velocity = vtkFloatArray::SafeDownCast(again.GetPointData()->GetArray("velocity"));
  ASSERT_TRUE(velocity);
  EXPECT_EQ(velocity->GetValue(8), 9);
  EXPECT_TRUE(std::isinf(velocity->GetValue(4)));
  EXPECT_EQ(again.GetPointData()->GetArray("image [1]")->GetComponent(2, 2), 9.5);
  ASSERT_EQ(again.GetCellData()->GetNumberOfArrays(), 1);
  ASSERT_TRUE(again.GetCellData()->GetScalars());
  EXPECT_EQ(again.GetCellData()->GetScalars()->GetDataType(), VTK_UNSIGNED_CHAR);
  EXPECT_EQ(again.GetCellData()->GetScalars()->GetComponent(2, 0), 3);
  EXPECT_TRUE(again.GetFieldData()->HasArray("title"));
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
  EXPECT_EQ(
      of("some.svg", "<svg width=\"10mm\"><title>t</title><g id=\"a\"><path style=\"fill:red\" d=\"\"/></g></svg>"),
      (Words{"ids", "styles", "titles", "widths and heights", "groups"}));
  std::string stl(84 + 50, '\0');
  stl[80] = 1;
  EXPECT_TRUE(of("plain.stl", stl).empty());
  stl[0] = 'B';
  stl.back() = '\x80';
  EXPECT_EQ(of("some.stl", stl), (Words{"header", "attribute bytes"}));
  EXPECT_EQ(of("some.geojson", "{\"properties\": {}}"), Words{"properties"});
  EXPECT_TRUE(of("points.csv", "0,0,0\n").empty());
}

}  // namespace
}  // namespace cageproof::reports
