// SPDX-License-Identifier: MIT
#include "cageproof/core/cage/mesh_io.h"

#include "support.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace cageproof::points_test {
namespace {

using testing_support::expect_parts;
using testing_support::input_error_of;
using testing_support::TemporaryFolder;

const std::vector<Vec3<double>> kPoints{{0.1, 2, -3}, {1e-300, 0, 5}};

std::vector<Vec3<double>> points_of(const std::string& name, std::string_view text) {
  const TemporaryFolder folder;
  return read_points(folder.write(name, text));
}

std::string error_of(const std::string& name, std::string_view text) {
  return input_error_of([&] { points_of(name, text); });
}

TEST(points_reads, text_in_its_usual_forms) {
  EXPECT_EQ(points_of("p.csv", "x,y,z\n0.1,2,-3\n1e-300,0,5\n"), kPoints);
  EXPECT_EQ(points_of("p.csv", "\xEF\xBB\xBF\"x\", \"y\", \"z\"\r\n0.1, 2, -3\r\n1e-300 , 0 ,5"), kPoints);
  EXPECT_EQ(points_of("p.csv", "x0,y0,z0\n0.1,2,-3\n1e-300,0,5\n"), kPoints);
  EXPECT_EQ(points_of("p.xyz", "# two points\n\n  0.1 2\t-3  # the first\n1e-300 0 5\n"), kPoints);
  EXPECT_EQ(points_of("p.TXT", "x y z\n0.1 +2 -3\n1e-300 0 0x5p0\n"), kPoints);
}

TEST(points_reads, names_of_other_columns_and_says_so) {
  const TemporaryFolder folder;
  const auto warnings_of = [&](std::string_view text) {
    return read_points_and_faces(folder.write("p.csv", text)).warnings;
  };
  EXPECT_EQ(warnings_of("id,lat,lon\n1,2,3\n"),
            std::vector<std::string>{(folder.path() / "p.csv").string() +
                                     ": the columns id, lat, lon are taken for x, y, z"});
  EXPECT_EQ(warnings_of("x,y,value\n1,2,3\n").size(), 1U);
  EXPECT_TRUE(warnings_of("px,py,pz\n1,2,3\n").empty());
  EXPECT_TRUE(warnings_of("cloud of two points\n1,2,3\n").empty());
  // As tables are written with an index.
  EXPECT_EQ(points_of("p.csv", ",x,y,z\n0,0.1,2,-3\n1,1e-300,0,5\n"), kPoints);
}

TEST(points_rejects, meshes_without_a_suffix_by_their_format) {
  const TemporaryFolder folder;
  for (const auto& [text, format, suffix] :
       std::initializer_list<std::array<std::string_view, 3>>{{"# made by hand\n\nv 0 0 0\n", "OBJ", ".obj"},
                                                              {"ply\nformat ascii 1.0\n", "PLY", ".ply"},
                                                              {"OFF\n1 0 0\n0 0 0\n", "OFF", ".off"},
                                                              {"solid a\n", "STL", ".stl"},
                                                              {"<?xml version=\"1.0\"?>\n", "XML", ".svg or .vtp"},
                                                              {"{\"type\":\"Point\"}", "JSON", ".geojson"}})
    expect_parts(input_error_of([&] { read_points(folder.write("points", text)); }),
                 {"points: a file in " + std::string(format) + " format", suffix});
}

TEST(points_reads, any_separator_and_no_extension) {
  EXPECT_EQ(points_of("p.csv", "x;y;z\n0.1;2;-3\n1e-300 ; 0; 5\n"), kPoints);
  EXPECT_EQ(points_of("p.tsv", "X\tY\tZ\n0.1\t2\t-3\n1e-300\t0\t5\n"), kPoints);
  EXPECT_EQ(points_of("points", "0.1 2 -3\n1e-300,0,5\n"), kPoints);
  EXPECT_EQ(points_of("p.xyz", "cloud of two points\n0.1 2 -3\n1e-300 0 5\n"), kPoints);
}

TEST(points_reads, a_line_that_counts_them) {
  EXPECT_EQ(points_of("p.pts", "2\n0.1 2 -3\n1e-300 0 5\n"), kPoints);
  expect_parts(error_of("p.pts", "# scan\n3\n0 0 0\n1 0 0\n"), {"p.pts:2: 3 points are announced, 2 follow"});
  expect_parts(error_of("p.pts", "2\n2\n0 0 0\n"), {"p.pts:2: ", "three coordinates"});
}

TEST(points_reads, three_columns_of_more_and_says_so) {
  const TemporaryFolder folder;
  const auto mesh = [&](std::string_view text, int dimension = 3) {
    return read_points_and_faces(folder.write("p.xyz", text), dimension);
  };
  const Mesh coloured = mesh("0.1 2 -3 255 red\n1e-300 0 5 0 blue\n");
  EXPECT_EQ(coloured.vertices, kPoints);
  ASSERT_EQ(coloured.warnings.size(), 1u);
  expect_parts(coloured.warnings[0], {"p.xyz: 2 of 5 columns are left out", "the first"});
  EXPECT_EQ(mesh("id;z;Y;\"x\"\na;-3;2;0.1\nb;5;0;1e-300\n").vertices, kPoints);
  EXPECT_EQ(mesh("x,y,r,g\n1,2,3,4\n", 2).vertices, (std::vector<Vec3<double>>{{1, 2, 0}}));
  EXPECT_TRUE(mesh("0 0 0\n").warnings.empty());
  expect_parts(error_of("p.csv", "id,lon,lat,h\n1,8.5,47,400\n"), {"p.csv:2: 4 columns", "none of them x, y, z"});
  expect_parts(error_of("p.csv", "x,y,z,r\n1,2,3\n"), {"p.csv:2: 3 numbers, the header names 4"});
}

TEST(points_rejects, decimal_commas) {
  for (const char* text : {"0,5;1,5;2,5\n", "0,5\t1,5\t2,5\n", "0,5 1,5 2,5\n", "0,5,1,5,2,5\n"})
    expect_parts(error_of("p.csv", text), {"p.csv:1: ", "decimal comma"});
}

std::string array_of(std::string_view type, bool by_columns, std::string_view shape, std::string_view data) {
  const std::string header = fmt::format("{{'descr': '{}', 'fortran_order': {}, 'shape': ({}), }}\n", type,
                                         by_columns ? "True" : "False", shape);
  return std::string("\x93NUMPY\x01\x00", 8) + static_cast<char>(header.size()) + '\0' + header + std::string(data);
}

template <class Number>
std::string bytes_of(std::initializer_list<Number> numbers, bool swap = false) {
  std::string bytes;
  for (const Number& x : numbers) {
    std::string one(reinterpret_cast<const char*>(&x), sizeof x);
    if (swap) std::ranges::reverse(one);
    bytes += one;
  }
  return bytes;
}

TEST(points_reads, arrays_of_numpy) {
  const std::vector<Vec3<double>> expected{{1, 2, 3}, {4, 5, 6}};
  const std::string rows = bytes_of({1., 2., 3., 4., 5., 6.});
  for (const char* name : {"p.npy", "p", "p.txt"})
    EXPECT_EQ(points_of(name, array_of("<f8", false, "2, 3", rows)), expected);
  EXPECT_EQ(points_of("p.npy", array_of("<f8", true, "2, 3", bytes_of({1., 4., 2., 5., 3., 6.}))), expected);
  EXPECT_EQ(points_of("p.npy", array_of("<f4", false, "2, 3", bytes_of({1.F, 2.F, 3.F, 4.F, 5.F, 6.F}))), expected);
  EXPECT_EQ(points_of("p.npy", array_of(">f8", false, "2, 3", bytes_of({1., 2., 3., 4., 5., 6.}, true))), expected);
  const TemporaryFolder folder;
  const auto flat = folder.write("p.npy", array_of("<f8", false, "3, 2", rows));
  EXPECT_EQ(read_points(flat, 2), (std::vector<Vec3<double>>{{1, 2, 0}, {3, 4, 0}, {5, 6, 0}}));
  expect_parts(input_error_of([&] { read_points(flat); }), {"p.npy: ", "two coordinates"});
  expect_parts(input_error_of([&] { read_points(folder.write("q.npy", array_of("<f8", false, "2, 3", rows)), 2); }),
               {"q.npy: vertex 0", "3D points for a polygon"});
}

TEST(points_rejects, arrays_of_other_types_and_shapes) {
  const std::string rows = bytes_of({1., 2., 3., 4., 5., 6.});
  expect_parts(error_of("p.npy", array_of("<i8", false, "2, 3", rows)), {"p.npy: its type is", "<i8", "float64"});
  expect_parts(error_of("p.npy", array_of("<f8", false, "3, 2, 1", rows)), {"its shape is (3, 2, 1)", "(points, 3)"});
  expect_parts(error_of("p.npy", array_of("<f8", false, "6,", rows)), {"its shape is (6)"});
  expect_parts(error_of("p.npy", array_of("<f8", false, "3, 3", rows)), {"3 points of 24 bytes", "48 bytes follow"});
  expect_parts(error_of("p.npy", array_of("<f8", false, "2, 3", rows + "x")), {"49 bytes follow"});
  expect_parts(error_of("p.npy", array_of("<f8", false, "18446744073709551615, 3", rows)), {"48 bytes follow"});
  expect_parts(error_of("p.npy", array_of("<f8", false, "0, 3", "")), {"no points"});
  expect_parts(error_of("p.npy", array_of("<f8", false, "1, 3", bytes_of({1., 2., HUGE_VAL}))), {"row 0", "inf"});
  expect_parts(error_of("p.npy", "1 2 3\n"), {"p.npy: ", "NumPy"});
  expect_parts(error_of("p.npy", std::string("\x93NUMPY\x01\x00\xff\x00", 10)), {"ends in its header"});
  expect_parts(error_of("p.npz", "PK"), {"p.npz: libarchive cannot read it"});
}

TEST(points_reads, vertices_of_a_mesh) {
  EXPECT_EQ(points_of("p.obj", "v 0.1 2 -3\nv 1e-300 0 5\nf 1 2 1\n"), kPoints);
}

TEST(points_rejects, points_in_the_plane) {
  expect_parts(error_of("p.csv", "0,1,2\n3,4\n"), {"p.csv:2: ", "three coordinates", "2"});
  expect_parts(error_of("p.csv", "x,y\n3,4\n"), {"p.csv:2: ", "three coordinates", "2"});
  expect_parts(error_of("p.xyz", "3 4\n"), {"p.xyz:1: ", "three coordinates", "2"});
  expect_parts(error_of("p.obj", "v 3 4\n"), {"p.obj:1: ", "three coordinates", "2"});
}

TEST(points_in_the_plane, have_two_numbers_or_a_zero) {
  const TemporaryFolder folder;
  const auto flat = [&](const std::string& name, std::string_view text) {
    return read_points(folder.write(name, text), 2);
  };
  const std::vector<Vec3<double>> points{{0.1, 2, 0}, {-3, 4, 0}};
  EXPECT_EQ(flat("p.csv", "x,y\n0.1,2\n-3,4\n"), points);
  EXPECT_EQ(flat("p.xyz", "0.1 2 0\n-3 4\n"), points);
  EXPECT_EQ(flat("p.obj", "v 0.1 2 0\nv -3 4 -0\n"), points);
  EXPECT_EQ(flat("p.obj", "v 0.1 2\nv -3 4\nl 1 2\n"), points);
  EXPECT_EQ(flat("p.svg", "<svg><path d='M.1-2-3-4'/></svg>"), points);
  EXPECT_EQ(flat("p.geojson", R"({"type":"MultiPoint","coordinates":[[0.1,2],[-3,4]]})"), points);
  expect_parts(input_error_of([&] { flat("p.csv", "0,1\n0,1,2\n"); }), {"p.csv:2: 3D points for a polygon", "\"2\""});
  expect_parts(input_error_of([&] { flat("p.csv", "0,1\n0\n"); }), {"p.csv:2: ", "two coordinates", "1"});
  expect_parts(input_error_of([&] { flat("p.csv", "0 1 255 0\n"); }), {"p.csv:1: 3D points for a polygon", "\"255\""});
  expect_parts(input_error_of([&] { flat("p.obj", "v 0 0 0\nv 0 0 1e-300\n"); }),
               {"p.obj: vertex 1", "3D points for a polygon", "1e-300"});
}

TEST(points_rejects, more_than_three_numbers) {
  expect_parts(error_of("p.csv", "0,1,2\n0,1,2,3\n"), {"p.csv:2: ", "4"});
}

TEST(points_rejects, fields_that_are_no_number) {
  expect_parts(error_of("p.csv", "0,1,2\n3,abc,4\n"), {"p.csv:2: ", "\"abc\""});
  expect_parts(error_of("p.csv", "1,abc,4\n"), {"p.csv:1: ", "\"abc\""});
  expect_parts(error_of("p.csv", "x,y,z\nx,y,z\n1,2,3\n"), {"p.csv:2: ", "\"x\""});
  expect_parts(error_of("p.csv", "1,,2\n"), {"p.csv:1: ", "empty"});
  EXPECT_EQ(points_of("p.csv", "0.1,2,-3,\n1e-300,0,5,\n"), kPoints);
  expect_parts(error_of("p.csv", "1 2,3\n"), {"p.csv:1: ", "field"});
  expect_parts(error_of("p.csv", "nan,nan,nan\n"), {"p.csv:1: ", "\"nan\""});
  expect_parts(error_of("p.csv", "1,2,1.#IND\n"), {"p.csv:1: ", "\"1.#IND\""});
  expect_parts(error_of("p.csv", "1,2,1e999\n"), {"p.csv:1: ", "\"1e999\""});
}

TEST(points_rejects, files_without_points) {
  const TemporaryFolder folder;
  expect_parts(input_error_of([&] { read_points(folder.path() / "missing.csv"); }), {"missing.csv: no such file"});
  expect_parts(error_of("p.csv", ""), {"p.csv: the file is empty"});
  expect_parts(error_of("p.csv", "x,y,z\n# none\n"), {"p.csv: no points"});
  expect_parts(error_of("p.jsn", "[]"), {"p.jsn: ", "\".jsn\"", ".csv"});
  expect_parts(error_of("p.json", "[]"), {"p.json:1: the document: is no GeoJSON object, but an array"});
  std::filesystem::create_directory(folder.path() / "folder.csv");
  expect_parts(input_error_of([&] { read_points(folder.path() / "folder.csv"); }), {"is a directory"});
}

}  // namespace
}  // namespace cageproof::points_test
