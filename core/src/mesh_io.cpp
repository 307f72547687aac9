// SPDX-License-Identifier: MIT
#include "cageproof/core/mesh_io.h"

#include "cageproof/core/scalar_text.h"
#include "mesh_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

namespace cageproof {
namespace {

using mesh_files::FileLine;

bool is_text_of_points(const std::string& extension) {
  return extension == ".csv" || extension == ".xyz" || extension == ".txt";
}

std::vector<std::string_view> fields_of(std::string_view line, const FileLine& at) {
  std::vector<std::string_view> fields;
  const bool has_commas = line.find(',') != std::string_view::npos;
  for (bool more = true; more;) {
    const std::size_t comma = line.find(',');
    std::string_view part = line.substr(0, comma);
    const std::size_t before = fields.size();
    for (auto token = mesh_files::take_token(part); !token.empty(); token = mesh_files::take_token(part))
      fields.push_back(token);
    if (has_commas && fields.size() != before + 1) at.fail("an empty or blank-separated field between commas");
    more = comma != std::string_view::npos;
    if (more) line.remove_prefix(comma + 1);
  }
  return fields;
}

std::vector<Vec3<double>> read_text_points(const std::filesystem::path& path) {
  const std::string file = mesh_files::read_mesh_file(path);
  std::string_view text = mesh_files::without_mark(file);
  std::vector<Vec3<double>> points;
  FileLine at{path};
  bool is_first = true;
  for (std::string_view line; mesh_files::take_line(text, line);) {
    ++at.line;
    line = line.substr(0, line.find('#'));
    if (line.find_first_not_of(" \t") == std::string_view::npos) continue;
    const auto fields = fields_of(line, at);
    const bool is_header =
        is_first && std::ranges::none_of(fields, [](auto f) { return parse_scalar<double>(f).has_value(); });
    is_first = false;
    if (is_header) continue;
    if (fields.size() != 3) at.fail(fmt::format("a point has three coordinates, here are {} numbers", fields.size()));
    Vec3<double>& point = points.emplace_back();
    for (int i = 0; i < 3; ++i) point[i] = mesh_files::finite_number(fields[i], at);
  }
  if (points.empty()) FileLine{path}.fail("no points");
  return points;
}

// Made when first asked for, so that readers may be added from any file before main.
std::map<std::string, MeshReader, std::less<>>& readers() {
  static std::map<std::string, MeshReader, std::less<>> instance{{".obj", mesh_files::read_obj}};
  return instance;
}

}  // namespace

RegisterMeshReader::RegisterMeshReader(std::string_view extension, MeshReader reader) {
  readers().emplace(extension, reader);
}

Mesh read_mesh(const std::filesystem::path& path) {
  const std::string extension = mesh_files::extension_of(path);
  if (const auto reader = readers().find(extension); reader != readers().end()) return reader->second(path);
  FileLine{path}.fail(fmt::format(
      "unknown extension \"{}\"; meshes are .obj, .ply, .stl or .vtp, points also .csv, .xyz or .txt", extension));
}

Cage read_cage(const std::filesystem::path& path, CageOptions options) {
  Mesh mesh = read_mesh(path);
  std::vector<Face> faces;
  for (const std::vector<int>& polygon : mesh.faces) {
    if (polygon.size() != 3 && polygon.size() != 4)
      FileLine{path}.fail(
          fmt::format("face {}: {} corners, a cage's faces have 3 or 4 (faces and vertices counted from 0)",
                      faces.size(), polygon.size()));
    std::ranges::copy(polygon, faces.emplace_back().vertices.begin());
  }
  options.face_lines = std::move(mesh.face_lines);
  return Cage::make(path.string(), std::move(mesh.vertices), std::move(faces), std::move(options));
}

std::vector<Vec3<double>> read_points(const std::filesystem::path& path) {
  return is_text_of_points(mesh_files::extension_of(path)) ? read_text_points(path) : read_mesh(path).vertices;
}

}  // namespace cageproof
