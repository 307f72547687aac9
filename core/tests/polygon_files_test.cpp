// SPDX-License-Identifier: MIT
// Polygons through all formats, and those of OBJ and VTP.
#include "cageproof/core/cage/mesh_io.h"

#include "cageproof/core/cage/embedded_cages.h"
#include "support.h"

#include <fmt/format.h>

#include <limits>

namespace cageproof {
namespace {

using testing_support::expect_parts;
using testing_support::input_error_of;
using testing_support::TemporaryFolder;

using Segments = std::vector<std::array<int, 2>>;

const std::string kSquare = "v 0 0\nv 1 0\nv 1 1\nv 0 1\n";

// The loops of an embedded cage, whose vertices stand one after the other.
std::vector<std::vector<int>> loops_of(const Cage& cage) {
  std::vector<std::vector<int>> loops(1);
  for (const Face& face : cage.faces()) {
    loops.back().push_back(face.vertices[0]);
    if (face.vertices[1] < face.vertices[0]) loops.emplace_back();
  }
  loops.pop_back();
  return loops;
}

std::string obj_of(const Cage& cage) {
  std::string text;
  for (const auto& v : cage.vertices()) text += fmt::format("v {} {} 0\n", v[0], v[1]);
  for (const auto& loop : loops_of(cage)) {
    text += "l";
    for (const int v : loop) text += fmt::format(" {}", v + 1);
    text += fmt::format(" {}\n", loop.front() + 1);
  }
  return text;
}

std::string svg_of(const Cage& cage) {
  std::string data;
  for (const auto& loop : loops_of(cage)) {
    data += "M";
    for (const int v : loop) data += fmt::format(" {} {}", cage.vertices()[v][0], -cage.vertices()[v][1]);
    data += " Z";
  }
  return fmt::format("<svg xmlns=\"http://www.w3.org/2000/svg\"><path d=\"{}\"/></svg>", data);
}

std::string geojson_of(const Cage& cage) {
  std::string rings;
  for (auto loop : loops_of(cage)) {
    loop.push_back(loop.front());
    std::string ring;
    for (const int v : loop)
      ring += fmt::format("{}[{},{}]", ring.empty() ? "" : ",", cage.vertices()[v][0], cage.vertices()[v][1]);
    rings += fmt::format("{}[{}]", rings.empty() ? "" : ",", ring);
  }
  return fmt::format(R"({{"type":"Polygon","coordinates":[{}]}})", rings);
}

std::string vtp_of(const std::string& points, std::size_t count, const std::string& connectivity,
                   const std::string& offsets, std::size_t lines) {
  return fmt::format(
      "<VTKFile type=\"PolyData\" version=\"0.1\"><PolyData><Piece NumberOfPoints=\"{}\" NumberOfVerts=\"0\" "
      "NumberOfLines=\"{}\" NumberOfStrips=\"0\" NumberOfPolys=\"0\"><Points><DataArray type=\"Float64\" "
      "NumberOfComponents=\"3\" format=\"ascii\">{}</DataArray></Points><Lines><DataArray type=\"Int32\" "
      "Name=\"connectivity\" format=\"ascii\">{}</DataArray><DataArray type=\"Int32\" Name=\"offsets\" "
      "format=\"ascii\">{}</DataArray></Lines></Piece></PolyData></VTKFile>",
      count, lines, points, connectivity, offsets);
}

std::string vtp_of(const Cage& cage) {
  std::string points, connectivity, offsets;
  for (const auto& v : cage.vertices()) points += fmt::format("{} {} 0 ", v[0], v[1]);
  std::size_t offset = 0, lines = 0;
  for (const auto& loop : loops_of(cage)) {
    for (const int v : loop) connectivity += fmt::format("{} ", v);
    connectivity += fmt::format("{} ", loop.front());
    offsets += fmt::format("{} ", offset += loop.size() + 1);
    ++lines;
  }
  return vtp_of(points, cage.vertices().size(), connectivity, offsets, lines);
}

std::vector<Cage> cages() {
  std::vector<Cage> found;
  for (const auto name : embedded_cage_names())
    if (Cage cage = embedded_cage(name); cage.dimension() == 2) found.push_back(std::move(cage));
  const Cage frame = embedded_cage("frame");
  auto ends_of_range = frame.vertices();
  for (auto& v : ends_of_range) v = 1e-310 * v + Vec3<double>(1e-310 / 3, 0, 0);
  found.push_back(frame.with(ends_of_range, frame.faces()));
  for (auto& v : ends_of_range) v *= 1e300, v *= 1e300;
  found.push_back(frame.with(ends_of_range, frame.faces()));
  return found;
}

TEST(polygon_files, give_back_every_embedded_polygon_bit_by_bit) {
  const TemporaryFolder folder;
  for (const Cage& cage : cages())
    for (const auto& [name, text] : {std::pair{"cage.obj", obj_of(cage)},
                                     {"cage.svg", svg_of(cage)},
                                     {"cage.geojson", geojson_of(cage)},
                                     {"cage.vtp", vtp_of(cage)}}) {
      const Cage again = read_cage(folder.write(name, text));
      EXPECT_EQ(again.dimension(), 2);
      EXPECT_EQ(again.vertices(), cage.vertices()) << cage.name() << " " << name;
      ASSERT_EQ(again.faces().size(), cage.faces().size()) << cage.name() << " " << name;
      for (std::size_t f = 0; f < cage.faces().size(); ++f)
        EXPECT_EQ(again.faces()[f].vertices, cage.faces()[f].vertices) << cage.name() << " " << name;
    }
}

Cage polygons(const std::string& coordinates) {
  const TemporaryFolder folder;
  return read_cage(folder.write("case.geojson", R"({"type":"MultiPolygon","coordinates":)" + coordinates + "}"));
}
std::string polygons_error(const std::string& coordinates) {
  return input_error_of([&] { polygons(coordinates); });
}

TEST(polygons, may_touch_in_points) {
  // Two corners; a corner on an edge; a hole at a corner; a hole whose corners all lie on the edges.
  const std::string square = "[[0,0],[4,0],[4,4],[0,4],[0,0]]";
  EXPECT_EQ(polygons("[[" + square + "],[[[4,4],[6,4],[6,6],[4,6],[4,4]]]]").faces().size(), 8u);
  EXPECT_EQ(polygons("[[" + square + "],[[[4,2],[6,1],[6,3],[4,2]]]]").faces().size(), 7u);
  EXPECT_EQ(polygons("[[" + square + ",[[0,0],[1,2],[2,1],[0,0]]]]").faces().size(), 7u);
  EXPECT_EQ(polygons("[[" + square + ",[[2,0],[0,2],[2,4],[4,2],[2,0]]]]").faces().size(), 8u);
  EXPECT_EQ(polygons("[[" + square + ",[[0,0],[2,3],[4,4],[3,1],[0,0]]]]").faces().size(), 8u);
  EXPECT_EQ(
      polygons("[[[[0,0],[2,0],[0,2],[0,0]]],[[[2,0],[4,0],[4,2],[2,0]]],[[[0,2],[4,2],[2,4],[0,2]]]]").faces().size(),
      9u);
  expect_parts(polygons_error("[[" + square + "],[[[2,0],[4,2],[2,4],[0,2],[2,0]]]]"), {"bounds a hole"});
  expect_parts(polygons_error("[[" + square + "],[[[0,0],[2,1],[1,2],[0,0]]]]"), {"bounds a hole"});
}

TEST(polygons, that_cross_at_a_corner_or_share_an_edge_are_named) {
  const std::string square = "[[0,0],[4,0],[4,4],[0,4],[0,0]]";
  expect_parts(polygons_error("[[" + square + "],[[[4,4],[2,3],[6,2],[4,4]]]]"), {"cross"});
  expect_parts(polygons_error("[[" + square + "],[[[4,2],[6,2],[2,3],[4,2]]]]"), {"cross"});
  expect_parts(polygons_error("[[" + square + "],[[[4,0],[6,0],[6,4],[4,4],[4,0]]]]"), {"lie on each other"});
  expect_parts(polygons_error("[[" + square + "],[" + square + "]]"), {"lie on each other"});
  expect_parts(polygons_error("[[[[0,0],[2,0],[2,2],[4,2],[4,4],[2,2],[0,0]]]]"), {"repeated"});
  expect_parts(polygons_error("[[[[0,0],[4,0],[2,0],[2,2],[0,0]]]]"), {"lie on each other"});
  expect_parts(polygons_error("[[[[0,0],[4,0],[4,4],[2,0],[0,4],[0,0]]]]"), {"touch each other, at vertex 3"});
}

Mesh obj_mesh(const std::string& text) {
  const TemporaryFolder folder;
  return read_mesh(folder.write("case.obj", text));
}
std::string obj_error(const std::string& text) {
  const TemporaryFolder folder;
  const auto path = folder.write("case.obj", text);
  return input_error_of([&] { read_cage(path); });
}

TEST(obj_polylines, are_read_in_all_forms) {
  const Segments square{{0, 1}, {1, 2}, {2, 3}, {3, 0}};
  for (const char* lines : {"l 1 2 3 4 1\n", "l 1 2\nl 2 3\nl 3 4\nl 4 1\n", "l -4 -3 -2 -1 -4\n", "l  1  2\t3 4 1 \n",
                            "l 1/1 2/2 3/3 4/4 1/1\n", "o x\ng y\nl 1 2 3\nusemtl z\nl 3 4 1\n", "l 1 2 3 4 1\r\n"}) {
    const Mesh mesh = obj_mesh(kSquare + lines);
    EXPECT_EQ(mesh.segments, square) << lines;
    EXPECT_EQ(mesh.segment_lines.size(), 4u);
    EXPECT_TRUE(mesh.faces.empty());
  }
  // Indices count back from the last vertex so far, and may name later ones.
  EXPECT_EQ(obj_mesh("v 0 0 0\nv 1 0 0\nl -2 -1 3 -2\nv 0 1 0\n").segments, (Segments{{0, 1}, {1, 2}, {2, 0}}));
}

TEST(obj_polylines, that_are_none_are_named) {
  expect_parts(obj_error(kSquare + "l 1 2 3 4\n"), {"case.obj: vertex 0: the polyline is open: segment 0 (line 5)"});
  expect_parts(obj_error(kSquare + "l 1\n"), {"case.obj:5: ", "at least two vertices, here are 1"});
  expect_parts(obj_error(kSquare + "l\n"), {"case.obj:5: ", "here are 0"});
  for (const char* index : {"5", "0", "-5", "1000000000000", "-2147483648"})
    expect_parts(obj_error(kSquare + fmt::format("l 1 2 {} 1\n", index)), {"case.obj:5: ", "out of range"});
  expect_parts(obj_error(kSquare + "l 1 2 x 1\n"), {"case.obj:5: ", "\"x\""});
  expect_parts(obj_error(kSquare + "l 1 2 2 3 4 1\n"), {"segment 1 (line 5)", "vertex 1 occurs twice"});
  expect_parts(obj_error(kSquare + "v 0 0\nl 1 2 3 4 5\n"), {"vertex 4: repeated", "vertex 0"});
  expect_parts(obj_error(kSquare + "v 2 2\nl 1 2 3 4 1\n"), {"vertex 4: no segment uses it"});
  expect_parts(obj_error(kSquare + "l 1 3 2 4 1\n"), {"segments 0 and 2 (lines 5 and 5) cross each other"});
  expect_parts(obj_error(kSquare + "l 4 3 2 1 4\n"), {"clockwise", "segment 0 (line 5)", "--flip-inward"});
  expect_parts(obj_error("v 0 0 0\nv 1 0 0.5\nv 0 1 0\nl 1 2 3 1\n"), {"vertex 1: 3D points for a polygon"});
  expect_parts(obj_error("v 0 0 0\nv 1 0 0\nv 0 1 0\nl 1 2 3 1\nf 1 2 3\n"),
               {"case.obj: 1 faces (the first in line 5) and 3 segments of polylines (the first in line 4)"});
  expect_parts(obj_error("v 0 0\nv 1 0\nv 0 1\nl 1 2 3 1\nf 1 2 3\n"), {"case.obj:1: a vertex has three coordinates"});
  expect_parts(obj_error("v 0 0\nv 1\nl 1 2\n"), {"case.obj:2: a vertex has three coordinates, here are 1"});
}

TEST(vtp_polylines, are_read_and_named) {
  const TemporaryFolder folder;
  const std::string points = "0 0 0 1 0 0 1 1 0 0 1 0";
  const auto cage = [&](const std::string& p, const std::string& connectivity, const std::string& offsets,
                        std::size_t lines) {
    return folder.write("case.vtp", vtp_of(p, 4, connectivity, offsets, lines));
  };
  EXPECT_EQ(read_cage(cage(points, "0 1 2 3 0", "5", 1)).faces().size(), 4u);
  EXPECT_EQ(read_cage(cage(points, "0 1 1 2 2 3 3 0", "2 4 6 8", 4)).faces().size(), 4u);
  expect_parts(input_error_of([&] { read_cage(cage(points, "0 1 2 3", "4", 1)); }),
               {"case.vtp: vertex 0: the polyline is open: segment 0 begins there"});
  expect_parts(input_error_of([&] { read_cage(cage(points, "0 1 2 7 0", "5", 1)); }),
               {"case.vtp: polyline 0: index 7 is out of range"});
  expect_parts(input_error_of([&] { read_cage(cage("0 0 0 1 0 2 1 1 0 0 1 0", "0 1 2 3 0", "5", 1)); }),
               {"case.vtp: vertex 1: 3D points for a polygon"});
}

}  // namespace
}  // namespace cageproof
