// SPDX-License-Identifier: MIT
// Polygons of GeoJSON files (RFC 7946), through nlohmann-json: rings, whose last position repeats the first and is no
// vertex of its own; line strings, which are polygons when they close; points and open lines, which are vertices only,
// and are left out beside polygons. Features without a geometry, and empty geometries, are passed over, as are all
// members that say nothing of a shape.
#include "cage/mesh_files.h"
#include "json_tree.h"
#include "outline.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <span>

namespace cageproof::mesh_files {
namespace {

// A value, and how it is reached: "features[2].geometry".
struct Place {
  const JsonValue& value;
  std::string name;

  std::string in_words() const { return name.empty() ? "the document" : name; }
};

// A shape, from one array of positions.
struct Shape {
  std::vector<OutlineVertex> vertices;
  std::string name, in;  // "Point", "features[2].geometry"
  std::size_t line;
  bool is_polygon() const {
    return name == "Polygon" || (vertices.size() > 2 && vertices.front().at == vertices.back().at);
  }
};

class GeoJsonReader {
 public:
  explicit GeoJsonReader(const std::filesystem::path& path) : path_(path) {}

  Mesh read_document(const JsonValue& root) {
    read({root, ""});
    Mesh mesh;
    const bool polygons = std::ranges::any_of(shapes_, &Shape::is_polygon);
    std::size_t left_out = 0;
    for (Shape& shape : shapes_) {
      if (!polygons || shape.is_polygon()) add(std::move(shape), mesh);
      else if (++left_out <= kMostNotes)
        mesh.warnings.push_back(fmt::format("{}:{}: {}: a {} beside polygons is left out", path_.string(), shape.line,
                                            shape.in, shape.name));
    }
    if (left_out > kMostNotes)
      mesh.warnings.push_back(
          fmt::format("{}: {} more points and open lines are left out", path_.string(), left_out - kMostNotes));
    return mesh;
  }

 private:
  static constexpr std::size_t kMostNotes = 10;

  static void add(Shape shape, Mesh& mesh) {
    for (const OutlineVertex& v : shape.vertices)
      if (v.at[2] != 0 && mesh.first_height == 0) mesh.first_height = v.line;
    add_outline(std::move(shape.vertices), shape.name == "Polygon", mesh);
  }

  void read(const Place& object) {
    if (object.value.type != JsonType::Object)
      fail(object, fmt::format("is no GeoJSON object, but {}", kind_of(object.value)));
    const JsonValue* type = object.value.find("type");
    if (!type || type->type != JsonType::String)
      fail(object, fmt::format("has no \"type\", as GeoJSON has; its keys are {}", first_keys(object.value)));
    const std::string& name = type->string;
    if (name == "FeatureCollection") return each(object, "features", [&](const Place& p) { read(p); });
    if (name == "GeometryCollection") return each(object, "geometries", [&](const Place& p) { read(p); });
    if (name == "Feature") {
      const Place geometry = member(object, "geometry");
      return geometry.value.type == JsonType::Null ? void() : read(geometry);
    }
    const auto shape = [&](int depth, auto read_one) { nested(member(object, "coordinates"), depth, read_one); };
    const auto keep = [&](const Place& p, std::vector<OutlineVertex> vertices, const char* shape) {
      shapes_.push_back({std::move(vertices), shape, object.in_words(), p.value.line});
    };
    const auto ring = [&](const Place& p) { keep(p, ring_at(p), "Polygon"); };
    const auto line = [&](const Place& p) { keep(p, line_at(p), "LineString"); };
    const auto point = [&](const Place& p) { keep(p, {vertex(p)}, "Point"); };
    if (name == "Polygon") return shape(1, ring);
    if (name == "MultiPolygon") return shape(2, ring);
    if (name == "LineString") return shape(0, line);
    if (name == "MultiLineString") return shape(1, line);
    if (name == "Point") return shape(0, point);
    if (name == "MultiPoint") return shape(1, point);
    fail(object, fmt::format("{} is no type of GeoJSON", shown(name)));
  }

  static std::string_view kind_of(const JsonValue& value) {
    switch (value.type) {
      case JsonType::Array: return "an array";
      case JsonType::String: return "a string";
      case JsonType::Number: return "a number";
      case JsonType::Object: return "an object";
      default: return "null, true or false";
    }
  }
  static std::string first_keys(const JsonValue& object) {
    constexpr std::size_t most = 5;
    std::vector<std::string> keys;
    keys.reserve(most + 1);
    for (const std::string& key : std::span(object.keys).first(std::min(object.keys.size(), most)))
      keys.push_back(shown(key));
    if (object.keys.size() > most) keys.emplace_back("...");
    return keys.empty() ? "none" : fmt::format("{}", fmt::join(keys, ", "));
  }
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
  // Calls f for all arrays at this depth within `array`.
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
  std::vector<OutlineVertex> ring_at(const Place& ring) {
    std::vector<OutlineVertex> positions = vertices(ring);
    if (positions.size() < 4)
      fail(ring, fmt::format("a ring has at least four positions, here are {}", positions.size()));
    if (positions.front().at != positions.back().at) fail(ring, "the ring is open: its last position is not its first");
    return positions;
  }
  std::vector<OutlineVertex> line_at(const Place& line) {
    std::vector<OutlineVertex> positions = vertices(line);
    if (positions.size() < 2) fail(line, "a line string has at least two positions, here is one");
    return positions;
  }

  [[noreturn]] void fail(const Place& place, const std::string& reason) const {
    FileLine{path_, place.value.line}.fail(fmt::format("{}: {}", place.in_words(), reason));
  }

  const std::filesystem::path& path_;
  std::vector<Shape> shapes_;
};

Mesh read_geojson(const std::filesystem::path& path) {
  const std::string file = read_mesh_file(path);
  Mesh mesh;
  try {
    const JsonValue root = parse_json_tree(without_mark(file));
    mesh = GeoJsonReader(path).read_document(root);
  } catch (const JsonFault& fault) {
    FileLine{path, fault.line}.fail(fault.reason);
  }
  if (mesh.vertices.empty()) FileLine{path}.fail("no geometry in it");
  return mesh;
}

const RegisterMeshReader geojson_reader{".geojson", read_geojson}, json_reader{".json", read_geojson};

}  // namespace
}  // namespace cageproof::mesh_files
