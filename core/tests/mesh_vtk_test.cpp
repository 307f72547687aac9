// SPDX-License-Identifier: MIT
// PLY, STL and VTP, whole and broken.
#include "cageproof/core/cage/mesh_io.h"

#include "support.h"

#include <fmt/format.h>

#include <bit>
#include <cstring>
#include <fstream>
#include <iterator>

namespace cageproof::mesh_vtk_test {
namespace {

using testing_support::expect_parts;
using testing_support::input_error_of;
using testing_support::TemporaryFolder;

const std::vector<Vec3<double>> kVertices{{0.1, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
const std::vector<std::vector<int>> kFaces{{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}};
// With vertices as they come in these faces.
const std::vector<std::vector<int>> kStlFaces{{0, 1, 2}, {0, 2, 3}, {2, 1, 3}, {0, 3, 1}};

template <class T>
void append(std::string& bytes, T x, bool is_big = false) {
  std::array<char, sizeof(T)> raw;
  std::memcpy(raw.data(), &x, sizeof x);
  if (is_big) std::reverse(raw.begin(), raw.end());
  bytes.append(raw.data(), raw.size());
}

std::string ply_header(std::string_view format) {
  return fmt::format(
      "ply\nformat {} 1.0\ncomment a tetrahedron\nelement vertex 4\nproperty double x\nproperty double y\nproperty "
      "double z\n"
      "property uchar red\nelement face 4\nproperty list uchar int vertex_indices\nend_header\n",
      format);
}

std::string text_ply() {
  std::string text = ply_header("ascii");
  for (const auto& v : kVertices) text += fmt::format("{} {} {} 255\n", v[0], v[1], v[2]);
  for (const auto& f : kFaces) text += fmt::format("3 {} {} {}\n", f[0], f[1], f[2]);
  return text;
}

std::string binary_ply(bool is_big) {
  std::string bytes = ply_header(is_big ? "binary_big_endian" : "binary_little_endian");
  for (const auto& v : kVertices) {
    for (int i = 0; i < 3; ++i) append(bytes, v[i], is_big);
    append(bytes, std::uint8_t{255});
  }
  for (const auto& f : kFaces) {
    append(bytes, std::uint8_t{3});
    for (const int corner : f) append(bytes, corner, is_big);
  }
  return bytes;
}

std::string text_stl() {
  std::string text = "solid tetrahedron\n";
  for (const auto& f : kFaces) {
    text += "facet normal 0 0 0\nouter loop\n";
    for (const int c : f) text += fmt::format("vertex {} {} {}\n", kVertices[c][0], kVertices[c][1], kVertices[c][2]);
    text += "endloop\nendfacet\n";
  }
  return text + "endsolid tetrahedron\n";
}

std::string binary_stl() {
  std::string bytes(80, ' ');
  append(bytes, std::uint32_t{4});
  for (const auto& f : kFaces) {
    bytes.append(12, '\0');
    for (const int c : f)
      for (int i = 0; i < 3; ++i) append(bytes, static_cast<float>(kVertices[c][i]));
    bytes.append(2, '\0');
  }
  return bytes;
}

std::string vtp() {
  return R"(<?xml version="1.0"?>
<VTKFile type="PolyData" version="0.1" byte_order="LittleEndian"><PolyData>
<Piece NumberOfPoints="4" NumberOfVerts="0" NumberOfLines="0" NumberOfStrips="0" NumberOfPolys="4">
<Points><DataArray type="Float64" NumberOfComponents="3" format="ascii">0.1 0 0 1 0 0 0 1 0 0 0 1</DataArray></Points>
<Polys><DataArray type="Int64" Name="connectivity" format="ascii">0 2 1 0 1 3 1 2 3 0 3 2</DataArray>
<DataArray type="Int64" Name="offsets" format="ascii">3 6 9 12</DataArray></Polys>
</Piece></PolyData></VTKFile>
)";
}

std::string replaced(std::string text, std::string_view what, std::string_view by) {
  const std::size_t at = text.find(what);
  EXPECT_NE(at, std::string::npos) << what;
  return text.replace(at, what.size(), by);
}

// The message, after making sure that nothing went to the terminal.
std::string error_of(const std::string& name, std::string_view content) {
  const TemporaryFolder folder;
  const auto path = folder.write(name, content);
  testing::internal::CaptureStderr();
  testing::internal::CaptureStdout();
  std::string message = input_error_of([&] { read_mesh(path); });
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "") << content.substr(0, 200);
  EXPECT_EQ(testing::internal::GetCapturedStdout(), "") << content.substr(0, 200);
  expect_parts(message, {name});
  return message;
}

TEST(ply_reads, text_and_binary_exactly) {
  const TemporaryFolder folder;
  const std::string windows = [] {
    std::string text;
    for (const char c : text_ply()) text += c == '\n' ? std::string("\r\n") : std::string(1, c);
    return text;
  }();
  const std::string unended = text_ply().substr(0, text_ply().size() - 1);
  const std::string old_mac = replaced(binary_ply(false), "end_header\n", "end_header\r");
  for (const std::string& content : {text_ply(), binary_ply(false), binary_ply(true), windows, unended, old_mac}) {
    const Mesh mesh = read_mesh(folder.write("mesh.ply", content));
    EXPECT_EQ(mesh.vertices, kVertices) << content.substr(0, 40);
    EXPECT_EQ(mesh.faces, kFaces) << content.substr(0, 40);
    EXPECT_FALSE(read_cage(folder.path() / "mesh.ply").has_quads());
  }
}

TEST(ply_reads, quads_other_elements_and_point_sets) {
  const TemporaryFolder folder;
  const std::string quad = replaced(replaced(text_ply(), "element face 4", "element face 1"),
                                    "3 0 2 1\n3 0 1 3\n3 1 2 3\n3 0 3 2\n", "4 0 1 2 3\n");
  EXPECT_EQ(read_mesh(folder.write("quad.ply", quad)).faces, (std::vector<std::vector<int>>{{0, 1, 2, 3}}));
  const std::string edges =
      replaced(text_ply(), "end_header", "element edge 1\nproperty int vertex1\nproperty int vertex2\nend_header");
  EXPECT_EQ(read_mesh(folder.write("edges.ply", edges + "0 1\n")).faces, kFaces);
  const std::string points = replaced(text_ply(), "element face 4\nproperty list uchar int vertex_indices\n", "");
  const Mesh mesh = read_mesh(folder.write("points.ply", points.substr(0, points.find("3 0 2 1"))));
  EXPECT_EQ(mesh.vertices, kVertices);
  EXPECT_TRUE(mesh.faces.empty());
}

TEST(ply_reads, legal_files_that_its_library_cannot) {
  const TemporaryFolder folder;
  const auto read = [&](const std::string& content) { return read_mesh(folder.write("legal.ply", content)); };
  const std::string between =
      replaced(text_ply(), "element face", "element edge 1\nproperty int vertex1\nproperty int vertex2\nelement face");
  EXPECT_EQ(read(replaced(between, "3 0 2 1", "0 1\n3 0 2 1")).faces, kFaces);
  const std::string colours =
      replaced(text_ply(), "property uchar red", "property uchar red\nproperty char green\nproperty uchar blue");
  std::string coloured = colours;
  for (const char* vertex : {"0.1 0 0 255", "\n1 0 0 255", "0 1 0 255", "0 0 1 255"})
    coloured = replaced(coloured, vertex, std::string(vertex) + " -1 255");
  EXPECT_EQ(read(coloured).faces, kFaces);
  const std::string normals = replaced(text_ply(), "property uchar red", "property float nx");
  EXPECT_EQ(read(replaced(normals, "0 1 0 255", "0 1 0 -nan")).vertices, kVertices);
  const std::string large = replaced(text_ply(), "0 1 0 255", "0 1e300 0 255");
  EXPECT_EQ(read(large).vertices[2], Vec3<double>(0, 1e300, 0)) << "beyond float";
  EXPECT_EQ(read(replaced(text_ply(), "comment a tetrahedron", "obj_info a tetrahedron")).faces, kFaces);
}

TEST(ply_rejects, everything_that_is_not_whole) {
  const std::string text = text_ply(), binary = binary_ply(false);
  const std::size_t text_body = text.find("end_header") + 11, binary_body = binary.find("end_header") + 11;
  for (std::size_t cut = 1; cut + 4 < text.size(); cut += cut < text_body ? 17 : 3)
    error_of("cut.ply", text.substr(0, cut));
  for (std::size_t cut = binary_body; cut < binary.size(); cut += 5)
    expect_parts(error_of("cut.ply", binary.substr(0, cut)), {"the file ends"});
}

TEST(ply_rejects, bad_content_naming_line_or_element) {
  const std::string text = text_ply();
  expect_parts(error_of("case.ply", replaced(text, "\n1 0 0 255", "\n1 abc 0 255")), {"case.ply:13: ", "\"abc\""});
  expect_parts(error_of("case.ply", replaced(text, "\n1 0 0 255", "\n1 nan 0 255")), {"case.ply:13: ", "\"nan\""});
  expect_parts(error_of("case.ply", replaced(text, "\n1 0 0 255", "\n1 0 255")),
               {"case.ply:16: ", "face 0: 0 corners", "line 13", "fewer"});
  expect_parts(error_of("case.ply", replaced(text, "\n1 0 0 255", "\n1 0 0 0 255")),
               {"case.ply:", "face 0", "line 13"});
  expect_parts(error_of("case.ply", replaced(text, "3 0 1 3", "3 0 1 1000000000000")),
               {"case.ply:17: ", "face 1", "out of range"});
  expect_parts(error_of("case.ply", replaced(text, "3 0 1 3", "3 0 1 -1")), {"case.ply:17: ", "out of range"});
  expect_parts(error_of("case.ply", replaced(text, "3 0 1 3", "-3 0 1 3")), {"case.ply:17: ", "length -3"});
  expect_parts(error_of("case.ply", replaced(text, "3 0 1 3", "2000000000 0 1 3")), {"case.ply:17: ", "3 to 255"});
  expect_parts(error_of("case.ply", replaced(text, "3 0 1 3", "2 0 1")), {"case.ply:17: ", "2 corners"});
  expect_parts(error_of("case.ply", replaced(text, "vertex 4", "vertex 1000000000000")), {"case.ply:4: ", "count"});
  expect_parts(error_of("case.ply", replaced(text, "vertex 4", "vertex -4")), {"case.ply:4: ", "count"});
  expect_parts(error_of("case.ply", replaced(text, "property double z\n", "")), {"case.ply: ", "\"z\""});
  expect_parts(error_of("case.ply", replaced(text, "double z", "real z")), {"case.ply:7: ", "\"real\""});
  expect_parts(error_of("case.ply", replaced(text, "vertex_indices", "corners")), {"case.ply: ", "vertex_indices"});
  expect_parts(error_of("case.ply", replaced(text, "ascii", "ebcdic")), {"case.ply: ", "\"ebcdic\""});
  expect_parts(error_of("case.ply", "solid\n"), {"case.ply:1: ", "not a PLY"});
  expect_parts(error_of("case.ply", replaced(text, "comment a", "remark a")), {"case.ply:3: ", "\"remark\""});
  std::string binary = binary_ply(false);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  std::memcpy(binary.data() + binary.find("end_header\n") + 11 + 25, &nan, sizeof nan);
  expect_parts(error_of("case.ply", binary), {"case.ply: ", "vertex 1", "not finite"});
}

TEST(ply_reads, numbers_in_whatever_lines_they_stand) {
  const TemporaryFolder folder;
  const std::string text = text_ply();
  const std::size_t body = text.find("end_header") + 11;
  std::string one_line = text, a_line_each = text;
  std::replace(one_line.begin() + body, one_line.end(), '\n', ' ');
  std::replace(a_line_each.begin() + body, a_line_each.end(), ' ', '\n');
  const std::string blank =
      replaced(replaced(text, "end_header\n", "\nend_header\n\n"), "255\n3 0", "255\n\n \t\n3 0") + "\n\n";
  for (const std::string& content : {one_line, a_line_each, blank}) {
    const Mesh mesh = read_mesh(folder.write("free.ply", content));
    EXPECT_EQ(mesh.vertices, kVertices);
    EXPECT_EQ(mesh.faces, kFaces);
  }
  expect_parts(error_of("more.ply", text + "\n7\n"), {"more.ply:21: ", "face 3", "more numbers"});
}

TEST(ply_rejects, triangle_strips) {
  const std::string strips = replaced(text_ply(), "element face 4", "element tristrips 1");
  expect_parts(error_of("strip.ply", replaced(strips, "3 0 2 1\n3 0 1 3\n3 1 2 3\n3 0 3 2", "4 0 1 2 3")),
               {"triangle strips; write them as triangles"});
}

TEST(binary_files, warn_of_bytes_behind_the_last_element) {
  const TemporaryFolder folder;
  EXPECT_TRUE(read_mesh(folder.write("whole.stl", binary_stl())).warnings.empty());
  EXPECT_TRUE(read_mesh(folder.write("whole.ply", binary_ply(false))).warnings.empty());
  for (const auto& [name, bytes] : {std::pair{"more.stl", binary_stl()}, std::pair{"more.ply", binary_ply(true)}}) {
    const Mesh mesh = read_mesh(folder.write(name, bytes + "\r\n"));
    EXPECT_EQ(mesh.faces, std::string_view(name) == "more.stl" ? kStlFaces : kFaces);
    ASSERT_EQ(mesh.warnings.size(), 1U) << name;
    expect_parts(mesh.warnings[0], {name, ": 2 bytes behind the last"});
  }
  const Mesh mesh = read_mesh(folder.write("more.stl", binary_stl() + "\r\n"));
  expect_parts(mesh.warnings[0], {"4 triangles need 284"});
}

TEST(stl_reads, keywords_in_any_case_and_spelling) {
  const TemporaryFolder folder;
  const std::string text = text_stl();
  std::string capitals = text;
  std::ranges::transform(capitals, capitals.begin(), [](unsigned char c) { return std::toupper(c); });
  std::string apart = text;
  for (const std::string_view word : {"endloop", "endfacet", "endsolid"})
    for (std::size_t at = 0; (at = apart.find(word, at)) != std::string::npos; at += 3) apart.insert(at + 3, " ");
  const std::string twice =
      replaced(text, "facet normal 0 0 0\nouter loop\nvertex 0.1 0 0\nvertex 1 0 0",
               "endsolid one\nsolid two\nfacet normal 0 0 0\nouter loop\nvertex 0.1 0 0\nvertex 1 0 0");
  for (const std::string& content :
       {capitals, apart, twice, replaced(text, "solid", "Solid"), "\n \n\n" + text, "\xEF\xBB\xBF" + text,
        replaced(text, "solid tetrahedron", "solid"),
        replaced(text, "solid tetrahedron",
                 "solid Gr\xC3\xB6\xC3\x9F"
                 "e"),
        replaced(text, "normal 0 0 0", "normal nan -nan nan"), replaced(text, "endsolid tetrahedron\n", "endsolid")}) {
    const Mesh mesh = read_mesh(folder.write("mesh.STL", content));
    EXPECT_EQ(mesh.vertices.size(), 4U) << content;
    EXPECT_EQ(mesh.faces.size(), 4U) << content;
  }
}

TEST(stl_reads, binary_files_that_begin_with_solid) {
  const TemporaryFolder folder;
  std::string bytes = binary_stl();
  for (const std::string_view begin : {"solid ", "SOLID by a program", "solid\nfacet normal 0 0 0"}) {
    bytes.replace(0, begin.size(), begin);
    EXPECT_EQ(read_mesh(folder.write("mesh.stl", bytes)).faces, kStlFaces) << begin;
  }
}

TEST(stl_reads, text_and_binary_with_equal_vertices_merged) {
  const TemporaryFolder folder;
  for (const std::string& content : {text_stl(), binary_stl()}) {
    const Cage cage = read_cage(folder.write("mesh.stl", content));
    EXPECT_EQ(cage.vertices().size(), 4u);
    EXPECT_EQ(cage.faces().size(), 4u);
    EXPECT_EQ(cage.vertices()[0], Vec3<double>(0.1f, 0, 0)) << "STL is single precision";
  }
}

TEST(stl_rejects, everything_that_is_not_whole) {
  const std::string text = text_stl(), binary = binary_stl();
  for (std::size_t cut = 1; cut < text.find("endsolid"); cut += 7) error_of("cut.stl", text.substr(0, cut));
  for (std::size_t cut = 1; cut < binary.size(); cut += 11) error_of("cut.stl", binary.substr(0, cut));
}

TEST(stl_rejects, bad_content) {
  expect_parts(error_of("case.stl", replaced(text_stl(), "vertex 1 0 0", "vertex 1 abc 0")),
               {"case.stl:6: ", "\"abc\""});
  expect_parts(error_of("case.stl", replaced(text_stl(), "vertex 1 0 0", "vertex 1 0")),
               {"case.stl:7: ", "\"endloop\""});
  expect_parts(error_of("case.stl", replaced(text_stl(), "vertex 1 0 0", "vertex 1 nan 0")),
               {"case.stl:", "\"nan\" is not a finite number"});
  expect_parts(error_of("case.stl", replaced(text_stl(), "vertex 1 0 0", "vertex 1e39 0 0")), {"single precision"});
  expect_parts(error_of("case.stl", replaced(text_stl(), "endloop", "vertex 1 1 1")), {"\"vertex\"", "\"endloop\""});
  expect_parts(error_of("case.stl", "facet normal 0 0 0\n"), {"case.stl:1: \"facet\" where \"solid\" is wanted"});
  expect_parts(error_of("case.stl", "solid\nendsolid\n"), {"case.stl: no triangles"});
  std::string infinite = binary_stl();
  const float infinity = std::numeric_limits<float>::infinity();
  std::memcpy(infinite.data() + 84 + 50 + 12, &infinity, sizeof infinity);
  expect_parts(error_of("case.stl", infinite), {"triangle 1", "not finite"});
  std::string huge = binary_stl();
  const std::uint32_t count = 2000000000;
  std::memcpy(huge.data() + 80, &count, sizeof count);
  expect_parts(error_of("case.stl", huge), {"case.stl: 284 bytes", "2000000000 triangles need 100000000084"});
}

TEST(vtp_reads, doubles_exactly) {
  const TemporaryFolder folder;
  const Mesh mesh = read_mesh(folder.write("mesh.vtp", vtp()));
  EXPECT_EQ(mesh.vertices, kVertices);
  EXPECT_EQ(mesh.faces, kFaces);
}

TEST(vtp_rejects, offsets_beyond_what_the_file_holds) {
  expect_parts(error_of("mesh.vtp", replaced(vtp(), "3 6 9 12", "3 6 9 1000000000")),
               {"ends a cell at entry 1000000000", "bytes hold"});
}

// Arrays within elements or appended, as base64 or bytes, compressed or not.
TEST(vtp_rejects, binary_arrays_that_are_cut_or_end_cells_beyond_the_file) {
  const TemporaryFolder folder;
  const auto content = [](const std::string& name) {
    std::ifstream file(CAGEPROOF_FUZZ_CORPUS "/vtp/" + name, std::ios::binary);
    return std::string(std::istreambuf_iterator<char>(file), {});
  };
  for (const std::string place : {"inline", "appended_base64", "appended_bytes"})
    for (const std::string packed : {"", "_packed"}) {
      const std::string name = place + packed;
      SCOPED_TRACE(name);
      const std::string whole = content(name);
      const Mesh mesh = read_mesh(folder.write("mesh.vtp", whole));
      EXPECT_EQ(mesh.vertices, kVertices);
      EXPECT_EQ(mesh.faces, kFaces);
      expect_parts(error_of("mesh.vtp", content(name + "_offsets_beyond")),
                   {"mesh.vtp: an array of offsets ends a cell at entry 2000000000", "bytes hold"});
      expect_parts(error_of("mesh.vtp", content(name + "_cut")), {"mesh.vtp: an array states ", "cut off"});
      // Without an end, too.
      for (std::size_t cut = whole.find("<Points"); cut < whole.size() - std::string_view("</VTKFile>").size();
           cut += 17)
        error_of("mesh.vtp", whole.substr(0, cut));
    }
}

TEST(vtp_rejects, numbers_that_are_none) {
  std::ifstream file(CAGEPROOF_FUZZ_CORPUS "/vtp/appended_base64", std::ios::binary);
  const std::string whole(std::istreambuf_iterator<char>(file), {});
  for (const char* offset : {"-8", "abc", ""})
    expect_parts(error_of("mesh.vtp", replaced(whole, "offset=\"0\"", std::string("offset=\"") + offset + '"')),
                 {"mesh.vtp: an array's offset", "is no number of bytes"});
  expect_parts(error_of("mesh.vtp", replaced(whole, "NumberOfComponents=\"3\"", "NumberOfComponents=\"-3\"")),
               {"mesh.vtp: an array has -3 components"});
  std::string deep = "<VTKFile type=\"PolyData\">";
  for (int i = 0; i < 100000; ++i) deep += "<a>";
  expect_parts(error_of("mesh.vtp", deep), {"deep: this is no VTP file"});
}

TEST(vtp_rejects, everything_that_is_not_whole) {
  const std::string text = vtp();
  for (std::size_t cut = 1; cut < text.find("</VTKFile>"); cut += 13) error_of("cut.vtp", text.substr(0, cut));
}

TEST(vtp_rejects, bad_content) {
  error_of("case.vtp", replaced(vtp(), "0.1 0 0 1", "0.1 abc 0 1"));
  error_of("case.vtp", replaced(vtp(), "0 2 1 0", "0 b 1 0"));
  error_of("case.vtp", replaced(vtp(), "3 6 9", "3 6 900000"));
  error_of("case.vtp", replaced(vtp(), "3 6 9", "6 3 9"));
  error_of("case.vtp", replaced(vtp(), "NumberOfComponents=\"3\"", "NumberOfComponents=\"2\""));
  error_of("case.vtp", replaced(replaced(vtp(), "<PolyData>", "<ImageData>"), "</PolyData>", "</ImageData>"));
  expect_parts(error_of("case.vtp", replaced(vtp(), "0.1 0 0 1", "0.1 nan 0 1")), {"vertex 0", "not finite"});
  expect_parts(error_of("case.vtp", replaced(vtp(), "0 2 1 0", "0 2 99999999 0")), {"face 0", "out of range"});
  expect_parts(error_of("case.vtp", replaced(vtp(), "0 2 1 0", "0 2 -1 0")), {"face 0", "out of range"});
  error_of("case.vtp", replaced(vtp(), "0 2 1 0", "0 2 1000000000000000000000 0"));
  for (const std::string_view count : {"NumberOfPoints", "NumberOfPolys"})
    expect_parts(error_of("case.vtp",
                          replaced(vtp(), fmt::format("{}=\"4\"", count), fmt::format("{}=\"1000000000000\"", count))),
                 {"states", "out of range"});
}

}  // namespace
}  // namespace cageproof::mesh_vtk_test
