// SPDX-License-Identifier: MIT
#include "cageproof/core/cage/mesh_io.h"

#include "support.h"

#include <fmt/format.h>

namespace cageproof {
namespace {

using testing_support::expect_parts;
using testing_support::input_error_of;
using testing_support::TemporaryFolder;

using Vertices = std::vector<Vec3<double>>;

const std::string kRing = "[[0,0],[4,0],[4,4],[0,0]]";

Mesh mesh_of(std::string_view text) {
  const TemporaryFolder folder;
  return read_mesh(folder.write("case.geojson", text));
}

std::string error_of(std::string_view text) {
  return input_error_of([&] { mesh_of(text); });
}

std::string geometry(std::string_view type, std::string_view coordinates) {
  return fmt::format(R"({{"type":"{}","coordinates":{}}})", type, coordinates);
}

std::string feature(std::string_view shape) {
  return fmt::format(R"({{"type":"Feature","properties":{{"type":"Polygon","a":[1,[2]]}},"geometry":{}}})", shape);
}

TEST(geojson_reads, polygons_however_they_are_wrapped) {
  const std::string polygon = geometry("Polygon", "[" + kRing + "]");
  for (const std::string& text :
       {polygon, geometry("MultiPolygon", "[[" + kRing + "]]"), feature(polygon),
        R"({"type":"FeatureCollection","features":[)" + feature("null") + "," + feature(polygon) + "]}",
        R"({"type":"GeometryCollection","geometries":[{"type":"GeometryCollection","geometries":[)" + polygon + "]}]}",
        feature(R"({"type":"GeometryCollection","geometries":[)" + polygon + "]}"), "\xEF\xBB\xBF " + polygon,
        R"({"bbox":[0,0,1,1],"coordinates":[)" + kRing + R"(],"crs":null,"type":"Polygon"})",
        geometry("LineString", kRing), geometry("MultiLineString", "[" + kRing + "]"),
        geometry("Polygon", "[[[0,0,0],[4.0,-0.0],[4e0,40E-1,0.0],[0,0]]]")}) {
    const Mesh mesh = mesh_of(text);
    EXPECT_EQ(mesh.vertices, (Vertices{{0, 0, 0}, {4, 0, 0}, {4, 4, 0}})) << text;
    EXPECT_EQ(mesh.segments, (std::vector<std::array<int, 2>>{{0, 1}, {1, 2}, {2, 0}})) << text;
  }
}

TEST(geojson_reads, holes_that_run_as_rfc_7946_says) {
  const TemporaryFolder folder;
  const auto path = folder.write("hole.geojson",
                                 geometry("Polygon", "[[[0,0],[9,0],[9,9],[0,9],[0,0]],\n[[1,1],[1,2],[2,2],[1,1]]]"));
  EXPECT_EQ(read_cage(path).faces().size(), 7u);
  const auto wrong = folder.write("wrong.geojson",
                                  geometry("Polygon", "[[[0,0],[9,0],[9,9],[0,9],[0,0]],\n[[1,1],[2,2],[1,2],[1,1]]]"));
  expect_parts(input_error_of([&] { read_cage(wrong); }),
               {"wrong.geojson: ", "3 segments from segment 4 (line 2) on", "bounds a hole"});
  EXPECT_NO_THROW(read_cage(wrong, {.flip_inward = true}));
}

TEST(geojson_reads, points_and_open_lines_as_points) {
  EXPECT_EQ(mesh_of(geometry("Point", "[1,2,3]")).vertices, (Vertices{{1, 2, 3}}));
  EXPECT_EQ(mesh_of(geometry("MultiPoint", "[[1,2],[3,4]]")).vertices, (Vertices{{1, 2, 0}, {3, 4, 0}}));
  const Mesh line = mesh_of(geometry("LineString", "[[1,2],[3,4],[5,7]]"));
  EXPECT_EQ(line.segments, (std::vector<std::array<int, 2>>{{0, 1}, {1, 2}}));
  EXPECT_EQ(mesh_of(R"({"type":"GeometryCollection","geometries":[)" + geometry("Polygon", "[]") + "," +
                    geometry("Point", "[]") + "," + geometry("Point", "[5,6]") + "]}")
                .vertices.size(),
            1u);
}

TEST(geojson_reads, numbers_correctly_rounded_and_lines_of_positions) {
  const Mesh mesh = mesh_of(
      "{\"type\": \"Polygon\",\n \"coordinates\": [\n  [\n   [0.1, 5e-324],\n   [0.30000000000000004,\n    1],\r\n"
      "   [9007199254740993, 123456789012345678901234567890], [0.1, 5e-324]\n  ]\n ]\n}\n");
  EXPECT_EQ(mesh.vertices,
            (Vertices{{0.1, 5e-324, 0}, {0.1 + 0.2, 1, 0}, {9007199254740992.0, 123456789012345678901234567890.0, 0}}));
  EXPECT_EQ(mesh.segment_lines, (std::vector<std::size_t>{5, 7, 7}));
}

TEST(geojson_rejects, rings_that_are_none) {
  const auto ring_error = [](std::string_view ring) {
    return error_of(geometry("Polygon", fmt::format("[{}]", ring)));
  };
  expect_parts(ring_error("[[0,0],[1,0],\n[1,1],[0,1]]"), {"case.geojson:1: coordinates[0]: the ring is open"});
  expect_parts(ring_error("[[0,0],[1,0],[0,0]]"), {"at least four positions, here are 3"});
  expect_parts(ring_error("[[0,0],\n[1],[1,1],[0,0]]"), {"case.geojson:2: coordinates[0][1]: ", "two numbers", "1"});
  expect_parts(ring_error("[[0,0],[1,0,0,0],[1,1],[0,0]]"), {"coordinates[0][1]", "here are 4"});
  expect_parts(ring_error("[[0,0],[1,\"0\"],[1,1],[0,0]]"), {"coordinates[0][1]", "not a number"});
  expect_parts(ring_error("[[0,0],[1,null],[1,1],[0,0]]"), {"coordinates[0][1]", "not a number"});
  expect_parts(ring_error("[[0,0],5,[1,1],[0,0]]"), {"coordinates[0][1]", "no position"});
  expect_parts(ring_error("[[0,0],[1,1e999],[1,1],[0,0]]"), {"case.geojson:1: ", "1e999", "range"});
  expect_parts(ring_error("[[0,0],[1,NaN],[1,1],[0,0]]"), {"malformed JSON"});
  expect_parts(error_of(geometry("Polygon", kRing)), {"coordinates[0][0]", "no position"});
  expect_parts(error_of(geometry("Polygon", "{}")), {"coordinates: is no array"});
  expect_parts(error_of(geometry("LineString", "[[0,0]]")), {"at least two positions"});
}

TEST(geojson_leaves_out, heights_of_polygons) {
  const TemporaryFolder folder;
  const auto path = folder.write("high.geojson", geometry("Polygon", "[[[0,0],[4,0],\n[4,4,5],[0,0]]]"));
  const Mesh mesh = as_cage_mesh(read_mesh(path), path);
  EXPECT_EQ(cage_from(mesh, path).vertices(), (Vertices{{0, 0, 0}, {4, 0, 0}, {4, 4, 0}}));
  ASSERT_EQ(mesh.warnings.size(), 1u);
  expect_parts(mesh.warnings[0], {"high.geojson:2: ", "heights", "left out"});
  EXPECT_EQ(read_points(path, 2)[2], Vec3<double>(4, 4, 0));
  EXPECT_EQ(read_points(path, 3)[2], Vec3<double>(4, 4, 5));
}

TEST(geojson_leaves_out, points_and_lines_beside_polygons) {
  const Mesh mesh = mesh_of("{\"type\":\"FeatureCollection\",\"features\":[\n" + feature(geometry("Point", "[5,6]")) +
                            ",\n" + feature(geometry("Polygon", "[" + kRing + "]")) + ",\n" +
                            feature(geometry("MultiLineString", "[[[0,0],[1,1]]]")) + "]}");
  EXPECT_EQ(mesh.vertices.size(), 3u);
  ASSERT_EQ(mesh.warnings.size(), 2u);
  expect_parts(mesh.warnings[0], {"case.geojson:2: features[0].geometry: a Point"});
  expect_parts(mesh.warnings[1], {"case.geojson:4: features[2].geometry: a LineString"});
}

TEST(geojson_reads, json_that_is_geojson) {
  const TemporaryFolder folder;
  EXPECT_EQ(read_cage(folder.write("a.json", geometry("Polygon", "[" + kRing + "]"))).faces().size(), 3u);
  expect_parts(input_error_of([&] { read_mesh(folder.write("b.json", R"({"schema":"x","maps":[]})")); }),
               {"b.json:1: the document: has no \"type\"", "\"schema\", \"maps\""});
  expect_parts(input_error_of([&] { read_mesh(folder.write("c.json", "5")); }), {"no GeoJSON object, but a number"});
}

TEST(geojson_rejects, points_of_space_and_open_lines_as_cages) {
  const TemporaryFolder folder;
  const auto error_of_cage = [&](const std::string& text) {
    const auto path = folder.write("cage.geojson", text);
    return input_error_of([&] { read_cage(path); });
  };
  expect_parts(error_of_cage(geometry("LineString", "[[0,0],[1,0],\n[1,1]]")),
               {"cage.geojson: vertex 0: the polyline is open: segment 0 (line 1)"});
  expect_parts(error_of_cage(geometry("Point", "[0,0]")), {"no faces", "polylines"});
  expect_parts(
      error_of_cage(geometry("MultiPolygon", "[[[[0,0],[2,0],[2,2],[0,0]]],\n[[[1,0.5],[3,0],[3,3],[1,0.5]]]]")),
      {"cage.geojson: segments 1 and 3 (lines 1 and 2) cross each other"});
}

TEST(geojson_rejects, what_is_no_geojson) {
  expect_parts(error_of(""), {"case.geojson: the file is empty"});
  expect_parts(error_of("{\n\"type\": \"Polygon\",\n"), {"case.geojson:3: malformed JSON"});
  expect_parts(error_of("{}x"), {"malformed JSON"});
  expect_parts(error_of("[]"), {"the document: is no GeoJSON object"});
  expect_parts(error_of("{}"), {"has no \"type\""});
  expect_parts(error_of(R"({"type":5})"), {"has no \"type\""});
  expect_parts(error_of(R"({"type":"Topology"})"), {"\"Topology\" is no type of GeoJSON"});
  expect_parts(error_of(R"({"type":"Polygon"})"), {"has no \"coordinates\""});
  expect_parts(error_of(R"({"type":"Feature","properties":{}})"), {"has no \"geometry\""});
  expect_parts(error_of(R"({"type":"FeatureCollection","features":{}})"), {"features: is no array"});
  expect_parts(
      error_of("{\"type\":\"FeatureCollection\",\"features\":[\n" + feature("null") + ",\n" + feature("[]") + "]}"),
      {"case.geojson:3: features[1].geometry: is no GeoJSON object"});
  expect_parts(error_of(R"({"type":"FeatureCollection","features":[]})"), {"no geometry in it"});
  expect_parts(error_of(R"({"type":"Polygon","type":"Point","coordinates":[]})"), {"\"type\" occurs twice"});
  expect_parts(error_of(std::string(1000000, '[')), {"nested more than 100 deep"});
  std::string wide = "\xFF\xFE";
  for (const char c : geometry("Polygon", "[" + kRing + "]")) wide += {c, '\0'};
  expect_parts(error_of(wide), {"case.geojson:1: malformed JSON"});
}

}  // namespace
}  // namespace cageproof
