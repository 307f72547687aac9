// SPDX-License-Identifier: MIT
// OBJ through tinyobjloader, behind a check: the loader takes "abc" for 0, fills in missing coordinates, wraps index
// 10^12 around, and rounds every second decimal wrongly (by up to 3 ulp). So the check gives the numbers, the loader
// the faces.
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
};

Vec3<double> check_vertex(std::string_view rest, const FileLine& at) {
  Vec3<double> vertex;
  int count = 0;  // beyond three: a weight, a colour
  for (std::string_view token = take_token(rest); !token.empty(); token = take_token(rest), ++count) {
    const double x = finite_number(token, at);
    if (count < 3) vertex[count] = x;
  }
  if (count < 3) at.fail(fmt::format("a vertex has three coordinates, here are {}", count));
  return vertex;
}

// A corner is i, i/j, i//k or i/j/k; only i matters here.
void check_corner(std::string_view token, const FileLine& at) {
  const std::string_view digits = token.substr(0, token.find('/'));
  int index = 0;
  const auto [end, error] = std::from_chars(digits.begin(), digits.end(), index);
  if (error == std::errc::result_out_of_range) at.fail("index " + shown(digits) + " is out of range");
  if (error != std::errc{} || end != digits.end() || token.find_first_not_of("0123456789/-") != std::string_view::npos)
    at.fail(shown(token) + " is not a face's corner");
  if (index == 0) at.fail("index 0 is out of range: OBJ counts from 1");
}

void check_face(std::string_view rest, const FileLine& at) {
  int count = 0;
  for (std::string_view token = take_token(rest); !token.empty(); token = take_token(rest), ++count)
    check_corner(token, at);
  if (count < 3) at.fail(fmt::format("a face has at least three corners, here are {}", count));
}

CheckedObj check_obj(const std::filesystem::path& path, std::string_view text) {
  CheckedObj checked;
  FileLine at{path};
  for (std::string_view line; take_line(text, line);) {
    ++at.line;
    const std::string_view keyword = take_token(line);
    if (keyword.empty() || keyword.starts_with('#')) continue;
    if (keyword == "v") {
      checked.vertices.push_back(check_vertex(line, at));
    } else if (keyword == "f") {
      check_face(line, at);
      checked.face_lines.push_back(at.line);
    } else if (!std::isalpha(static_cast<unsigned char>(keyword.front()))) {
      at.fail(shown(keyword) + " is not an OBJ keyword");
    }
  }
  if (checked.vertices.empty()) FileLine{path}.fail("no vertices");
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
  return mesh;
}

}  // namespace cageproof::mesh_files
