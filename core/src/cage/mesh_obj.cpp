// SPDX-License-Identifier: MIT
// OBJ through tinyobjloader, behind a check: the loader takes "abc" for 0, fills in missing coordinates, wraps index
// 10^12 around, and rounds every second decimal wrongly (by up to 3 ulp). So the check gives the numbers, the loader
// the faces. Of polylines it takes "l  1 2", with two blanks, for 1 1 2: these are the check's too.
#include "mesh_files.h"

#include <fmt/format.h>
#include <tiny_obj_loader.h>

#include <cctype>
#include <charconv>
#include <sstream>

namespace cageproof::mesh_files {
namespace {

struct CheckedObj {
  std::vector<Vec3<double>> vertices;
  std::vector<std::size_t> face_lines;
  std::vector<std::array<int, 2>> segments;
  std::vector<std::size_t> segment_lines;
  std::size_t flat_line = 0;  // of the first vertex with two coordinates
};

[[noreturn]] void fail_flat(const FileLine& at, int count) {
  at.fail(fmt::format("a vertex has three coordinates, here are {}", count));
}

void check_vertex(std::string_view rest, const FileLine& at, CheckedObj& checked) {
  Vec3<double> vertex = Vec3<double>::Zero();
  int count = 0;  // beyond three: a weight, a colour
  for (std::string_view token = take_token(rest); !token.empty(); token = take_token(rest), ++count) {
    const double x = finite_number(token, at);
    if (count < 3) vertex[count] = x;
  }
  if (count < 2) fail_flat(at, count);
  if (count == 2 && checked.flat_line == 0) checked.flat_line = at.line;
  checked.vertices.push_back(vertex);
}

// A corner is i, i/j, i//k or i/j/k; only i matters here, and is what it returns.
int check_corner(std::string_view token, const FileLine& at) {
  const std::string_view digits = token.substr(0, token.find('/'));
  int index = 0;
  const auto [end, error] = std::from_chars(digits.begin(), digits.end(), index);
  if (error == std::errc::result_out_of_range) at.fail("index " + shown(digits) + " is out of range");
  if (error != std::errc{} || end != digits.end() || token.find_first_not_of("0123456789/-") != std::string_view::npos)
    at.fail(shown(token) + " is not a face's corner");
  if (index == 0) at.fail("index 0 is out of range: OBJ counts from 1");
  return index;
}

void check_face(std::string_view rest, const FileLine& at) {
  int count = 0;
  for (std::string_view token = take_token(rest); !token.empty(); token = take_token(rest), ++count)
    check_corner(token, at);
  if (count < 3) at.fail(fmt::format("a face has at least three corners, here are {}", count));
}

void check_polyline(std::string_view rest, const FileLine& at, CheckedObj& checked) {
  int count = 0, before = 0;
  for (std::string_view token = take_token(rest); !token.empty(); token = take_token(rest), ++count) {
    const int index = check_corner(token, at);
    const int vertex = index > 0 ? index - 1 : static_cast<int>(checked.vertices.size()) + index;
    if (vertex < 0)
      at.fail(fmt::format("index {} is out of range, {} vertices are before it", index, checked.vertices.size()));
    if (count > 0) {
      checked.segments.push_back({before, vertex});
      checked.segment_lines.push_back(at.line);
    }
    before = vertex;
  }
  if (count < 2) at.fail(fmt::format("a polyline has at least two vertices, here are {}", count));
}

void check_indices(const CheckedObj& checked, const std::filesystem::path& path) {
  const int count = static_cast<int>(checked.vertices.size());
  for (std::size_t s = 0; s < checked.segments.size(); ++s)
    for (const int vertex : checked.segments[s])
      if (vertex >= count)
        FileLine{path, checked.segment_lines[s]}.fail(
            fmt::format("vertex {} is out of range, the file has {} vertices", vertex + 1, count));
}

CheckedObj check_obj(const std::filesystem::path& path, std::string_view text) {
  CheckedObj checked;
  FileLine at{path};
  for (std::string_view line; take_line(text, line);) {
    ++at.line;
    const std::string_view keyword = take_token(line);
    if (keyword.empty() || keyword.starts_with('#')) continue;
    if (keyword == "v") {
      check_vertex(line, at, checked);
    } else if (keyword == "f") {
      check_face(line, at);
      checked.face_lines.push_back(at.line);
    } else if (keyword == "l") {
      check_polyline(line, at, checked);
    } else if (!std::isalpha(static_cast<unsigned char>(keyword.front()))) {
      at.fail(shown(keyword) + " is not an OBJ keyword");
    }
  }
  if (checked.vertices.empty()) FileLine{path}.fail("no vertices");
  // Nobody writes two coordinates but of polygons.
  const bool polygons = !checked.segments.empty() && checked.face_lines.empty();
  if (checked.flat_line > 0 && !polygons) fail_flat({path, checked.flat_line}, 2);
  check_indices(checked, path);
  return checked;
}

struct Faces {
  std::vector<std::vector<int>> faces;
  int vertices_so_far = 0;
};

std::vector<std::vector<int>> load_faces(const std::filesystem::path& path, std::string_view text) {
  Faces result;
  tinyobj::callback_t callback;
  callback.vertex_cb = [](void* user, double, double, double, double) { ++static_cast<Faces*>(user)->vertices_so_far; };
  callback.index_cb = [](void* user, tinyobj::index_t* corners, int count) {
    Faces& faces = *static_cast<Faces*>(user);
    std::vector<int>& face = faces.faces.emplace_back();
    for (int k = 0; k < count; ++k) {
      const int index = corners[k].vertex_index;  // from 1, or counted back from the last vertex so far
      face.push_back(index > 0 ? index - 1 : faces.vertices_so_far + index);
    }
  };
  std::istringstream stream{std::string(text)};
  std::string warning, error;
  if (!tinyobj::LoadObjWithCallback(stream, callback, &result, nullptr, &warning, &error))
    FileLine{path}.fail("tinyobjloader cannot read it: " + error);
  return std::move(result.faces);
}

}  // namespace

Mesh read_obj(const std::filesystem::path& path) {
  const std::string file = read_mesh_file(path);
  const std::string_view text = without_mark(file);
  CheckedObj checked = check_obj(path, text);
  Mesh mesh{std::move(checked.vertices), load_faces(path, text), {}};
  const int count = static_cast<int>(mesh.vertices.size());
  for (std::size_t f = 0; f < mesh.faces.size(); ++f)
    for (const int vertex : mesh.faces[f])
      if (vertex < 0 || vertex >= count)
        FileLine{path, checked.face_lines.at(f)}.fail(
            fmt::format("vertex {} is out of range, the file has {} vertices", vertex + 1, count));
  mesh.face_lines = std::move(checked.face_lines);
  mesh.segments = std::move(checked.segments);
  mesh.segment_lines = std::move(checked.segment_lines);
  return mesh;
}

}  // namespace cageproof::mesh_files
