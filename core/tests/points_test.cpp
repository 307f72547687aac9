// SPDX-License-Identifier: MIT
#include "cageproof/core/cage/mesh_io.h"

#include "support.h"

namespace cageproof {
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
  EXPECT_THROW(points_of("p.csv", "1;1;1\n2 2 2\n"), InputError);  // no header: a separator that is none
  EXPECT_EQ(points_of("p.xyz", "# two points\n\n  0.1 2\t-3  # the first\n1e-300 0 5\n"), kPoints);
  EXPECT_EQ(points_of("p.TXT", "x y z\n0.1 +2 -3\n1e-300 0 0x5p0\n"), kPoints);
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
  expect_parts(input_error_of([&] { flat("p.csv", "0,1,0,0\n"); }), {"p.csv:1: ", "two coordinates", "4"});
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
  expect_parts(error_of("p.csv", "1,2,3,\n"), {"p.csv:1: ", "empty"});
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
  expect_parts(error_of("p.json", "[]"), {"p.json: ", "\".json\"", ".csv"});
  std::filesystem::create_directory(folder.path() / "folder.csv");
  expect_parts(input_error_of([&] { read_points(folder.path() / "folder.csv"); }), {"is a directory"});
}

}  // namespace
}  // namespace cageproof
