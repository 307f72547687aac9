// SPDX-License-Identifier: MIT
// Polygons of GeoJSON files (RFC 7946), through nlohmann-json: rings, whose last position repeats the first and is no
// vertex of its own; line strings, which are polygons when they close; points, which are vertices alone. Features
// without a geometry, and empty geometries, are passed over, as are all members that say nothing of a shape.
#include "cage/mesh_files.h"
#include "json_tree.h"
#include "outline.h"

#include <fmt/format.h>

#include <array>

namespace cageproof::mesh_files {
namespace {

// A value, and how it is reached: "features[2].geometry".
struct Place {
  const JsonValue& value;
  std::string name;

  std::string in_words() const { return name.empty() ? "the document" : name; }
};

class GeoJsonReader {
 public:
  GeoJsonReader(const std::filesystem::path& path, Mesh& mesh) : path_(path), mesh_(mesh) {}

  void read(const Place& object) {
    if (object.value.type != JsonType::Object) fail(object, "is no GeoJSON object");
    const JsonValue* type = object.value.find("type");
    if (!type || type->type != JsonType::String) fail(object, "has no \"type\"");
    const std::string& name = type->string;
    if (name == "FeatureCollection") return each(object, "features", [&](const Place& p) { read(p); });
    if (name == "GeometryCollection") return each(object, "geometries", [&](const Place& p) { read(p); });
    if (name == "Feature") {
      const Place geometry = member(object, "geometry");
      return geometry.value.type == JsonType::Null ? void() : read(geometry);
    }
    const auto shape = [&](int depth, auto read_one) { nested(member(object, "coordinates"), depth, read_one); };
    const auto ring = [&](const Place& p) { read_ring(p); };
    const auto line = [&](const Place& p) { read_line(p); };
    const auto point = [&](const Place& p) { add_outline({vertex(p)}, false, mesh_); };
    if (name == "Polygon") return shape(1, ring);
    if (name == "MultiPolygon") return shape(2, ring);
    if (name == "LineString") return shape(0, line);
    if (name == "MultiLineString") return shape(1, line);
    if (name == "Point") return shape(0, point);
    if (name == "MultiPoint") return shape(1, point);
    fail(object, fmt::format("{} is no type of GeoJSON", shown(name)));
  }

 private:
  Place member(const Place& object, const std::string& key) const {
    const JsonValue* value = object.value.find(key);
    if (!value) fail(object, fmt::format("has no \"{}\"", key));
    return {*value, object.name.empty() ? key : object.name + "." + key};
  }
  template <class F>
  void each_item(const Place& array, F&& f) {
    if (array.value.type != JsonType::Array) fail(array, "is no array");
    for (std::size_t i = 0; i < array.value.items.size(); ++i)
      f(Place{array.value.items[i], fmt::format("{}[{}]", array.name, i)});
  }
  template <class F>
  void each(const Place& object, const std::string& key, F&& f) {
    each_item(member(object, key), f);
  }
  // Calls f for all arrays that are so deep within.
  template <class F>
  void nested(const Place& array, int depth, F&& f) {
    if (depth == 0) {
      if (array.value.type != JsonType::Array) fail(array, "is no array");
      if (!array.value.items.empty()) f(array);
      return;
    }
    each_item(array, [&](const Place& p) { nested(p, depth - 1, f); });
  }

  OutlineVertex vertex(const Place& position) const {
    const auto& numbers = position.value.items;
    if (position.value.type != JsonType::Array) fail(position, "is no position");
    if (numbers.size() < 2 || numbers.size() > 3)
      fail(position, fmt::format("a position has two numbers, or three, here are {}", numbers.size()));
    Vec3<double> at = Vec3<double>::Zero();
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      if (numbers[i].type != JsonType::Number) fail(position, "a coordinate is not a number");
      at[i] = numbers[i].number;
    }
    return {at, position.value.line};
  }
  std::vector<OutlineVertex> vertices(const Place& positions) {
    std::vector<OutlineVertex> found;
    each_item(positions, [&](const Place& p) { found.push_back(vertex(p)); });
    return found;
  }
  void read_ring(const Place& ring) {
    std::vector<OutlineVertex> positions = vertices(ring);
    if (positions.size() < 4)
      fail(ring, fmt::format("a ring has at least four positions, here are {}", positions.size()));
    if (positions.front().at != positions.back().at) fail(ring, "the ring is open: its last position is not its first");
    add_outline(std::move(positions), true, mesh_);
  }
  void read_line(const Place& line) {
    std::vector<OutlineVertex> positions = vertices(line);
    if (positions.size() < 2) fail(line, "a line string has at least two positions, here is one");
    add_outline(std::move(positions), false, mesh_);
  }

  [[noreturn]] void fail(const Place& place, const std::string& reason) const {
    FileLine{path_, place.value.line}.fail(fmt::format("{}: {}", place.in_words(), reason));
  }

  const std::filesystem::path& path_;
  Mesh& mesh_;
};

Mesh read_geojson(const std::filesystem::path& path) {
  const std::string file = read_mesh_file(path);
  Mesh mesh;
  try {
    const JsonValue root = parse_json_tree(without_mark(file));
    GeoJsonReader(path, mesh).read({root, ""});
  } catch (const JsonFault& fault) {
    FileLine{path, fault.line}.fail(fault.reason);
  }
  if (mesh.vertices.empty()) FileLine{path}.fail("no geometry in it");
  return mesh;
}

const RegisterMeshReader geojson_reader{".geojson", read_geojson};

}  // namespace
}  // namespace cageproof::mesh_files
