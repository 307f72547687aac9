// SPDX-License-Identifier: MIT
#include "cageproof/core/cage/mesh_io.h"

#include "support.h"

#include <fmt/format.h>

namespace cageproof::mesh_off_test {
namespace {

using testing_support::expect_parts;
using testing_support::input_error_of;
using testing_support::TemporaryFolder;

const std::vector<Vec3<double>> kVertices{{0.1, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
const std::vector<std::vector<int>> kFaces{{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}};
const std::string kPlaces = "0.1 0 0\n1 0 0\n0 1 0\n0 0 1\n";
const std::string kIndices = "3 0 2 1\n3 0 1 3\n3 1 2 3\n3 0 3 2\n";

std::string error_of(std::string_view text) {
  const TemporaryFolder folder;
  const auto path = folder.write("case.off", text);
  return input_error_of([&] { read_mesh(path); });
}

TEST(off_reads, every_header_and_passes_over_what_it_does_not_need) {
  const TemporaryFolder folder;
  const std::string more = "0.1 0 0 255 0 0 255\n1 0 0 255 0 0 255\n0 1 0 0 0 1 1\n0 0 1 0 0 1 1\n";
  const std::string coloured = "3 0 2 1 255 0 0\n3 0 1 3 0.5 0.5 0.5 1\n3 1 2 3 7\n3 0 3 2 # last\n";
  std::string windows = "\xEF\xBB\xBFOFF\r\n4 4 6\r\n";
  for (const char c : kPlaces + kIndices) windows += c == '\n' ? std::string("\r\n") : std::string(1, c);
  std::vector<std::string> texts{
      "OFF\n4 4 6\n" + kPlaces + kIndices,
      "OFF 4 4 6\n" + kPlaces + kIndices,
      "OFF4 4 6\n" + kPlaces + kIndices,
      "OFF\n4 4\n" + kPlaces + kIndices,
      "4 4 0\n" + kPlaces + kIndices,
      "\n# made by hand\nOFF # text\n# counts\n\n4 4 0\n\n" + kPlaces + "\n# faces\n" + kIndices,
      "OFF\n4 4 0\n0.1 0 0 1 0 0\n0 1\n0 0 0 1\n3 0\n2 1\n3 0 1 3\n3 1 2 3\n3 0 3 2",
      "OFF\n4 4 0\n" + kPlaces + coloured,
      windows};
  for (const char* keyword : {"COFF", "NOFF", "CNOFF", "STOFF"})
    texts.push_back(fmt::format("{}\n4 4 0\n{}{}", keyword, more, coloured));
  for (const std::string& text : texts)
    for (const char* name : {"mesh.off", "mesh.OFF"}) {
      const Mesh mesh = read_mesh(folder.write(name, text));
      EXPECT_EQ(mesh.vertices, kVertices) << text;
      EXPECT_EQ(mesh.faces, kFaces) << text;
      EXPECT_EQ(read_points(folder.path() / name), kVertices) << text;
      EXPECT_NO_THROW(read_cage(folder.path() / name)) << text;
    }
}

TEST(off_reads, quads_point_sets_and_lines_of_faces) {
  const TemporaryFolder folder;
  EXPECT_EQ(read_mesh(folder.write("quad.off", "OFF\n4 1 0\n" + kPlaces + "4 0 1 2 3\n")).faces,
            (std::vector<std::vector<int>>{{0, 1, 2, 3}}));
  EXPECT_EQ(read_mesh(folder.write("points.off", "OFF\n4 0 0\n" + kPlaces)).vertices, kVertices);
  const auto hole = folder.write("hole.off", "OFF\n4 3 0\n" + kPlaces + kIndices.substr(8));
  expect_parts(input_error_of([&] { read_cage(hole); }), {"hole.off: face 0 (line 7)", "hole"});
}

TEST(off_rejects, everything_that_is_not_whole) {
  const std::string text = "OFF\n4 4 6\n" + kPlaces + kIndices;
  for (std::size_t cut = 0; cut + 1 < text.size(); ++cut) expect_parts(error_of(text.substr(0, cut)), {"case.off"});
}

TEST(off_rejects, bad_content_naming_line_and_element) {
  expect_parts(error_of("version 1\n"), {"case.off:1: \"version\" where \"OFF\" is wanted"});
  expect_parts(error_of("4OFF\n4 4 6\n"), {"case.off:1: \"4OFF\"", "COFF"});
  expect_parts(error_of(std::string("OFF BINARY\n\0\0\0\4", 15)), {"case.off:1: binary OFF; write it as text"});
  expect_parts(error_of("OFF\n4.5 4 6\n"), {"case.off:2: \"4.5\"", "number of vertices"});
  expect_parts(error_of("OFF\n0 0 0\n"), {"case.off: no vertices"});
  const std::string head = "OFF\n4 4 6\n";
  expect_parts(error_of(head + "0 0 nan\n"), {"case.off:3: \"nan\" is not a finite number"});
  expect_parts(error_of(head + "0 0 1.#IND\n"), {"case.off:3: \"1.#IND\" is not a finite number"});
  expect_parts(error_of(head + kPlaces + "3 0 2 4\n"), {"case.off:7: face 0: index 4 is out of range"});
  expect_parts(error_of(head + kPlaces + "3 0 2 -1\n"), {"case.off:7: face 0: \"-1\""});
  expect_parts(error_of(head + kPlaces + "2 0 1\n"), {"case.off:7: face 0: \"2\"", "corners"});
  expect_parts(error_of(head + kPlaces + kIndices + "3 0 1 2\n"), {"case.off:11: ", "behind the last"});
  expect_parts(error_of(head + "0 0 0\n1 0\n" + kPlaces + kIndices), {"case.off:", "without three numbers is 4"});
  expect_parts(error_of("OFF\n2000000000 1 0\n0 0 0\n"), {"case.off:3: vertex 1: the file ends"});
}

}  // namespace
}  // namespace cageproof::mesh_off_test
