// SPDX-License-Identifier: MIT
#include "cageproof/core/cage/mesh_io.h"

#include "cageproof/core/numbers/scalar_text.h"
#include "mesh_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <map>

namespace cageproof {
namespace {

using mesh_files::FileLine;

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

Vec3<double> point_of(const std::vector<std::string_view>& fields, int dimension, const FileLine& at) {
  const bool right = fields.size() == 3 || (dimension == 2 && fields.size() == 2);
  if (!right)
    at.fail(fmt::format("a point has {} coordinates, here are {} numbers", dimension == 3 ? "three" : "two",
                        fields.size()));
  Vec3<double> point = Vec3<double>::Zero();
  for (std::size_t i = 0; i < fields.size(); ++i) point[i] = mesh_files::finite_number(fields[i], at);
  if (dimension == 2 && point[2] != 0)
    at.fail(fmt::format("3D points for a polygon: the third number is {}, not 0", mesh_files::shown(fields[2])));
  return point;
}

std::vector<Vec3<double>> read_text_points(const std::filesystem::path& path, int dimension) {
  const std::string file = mesh_files::read_mesh_file(path);
  std::string_view text = mesh_files::without_mark(file);
  std::vector<Vec3<double>> points;
  FileLine at{path};
  bool is_first = true;
  for (std::string_view line; mesh_files::take_line(text, line);) {
    ++at.line;
    line = mesh_files::without_comment(line);
    if (line.find_first_not_of(" \t") == std::string_view::npos) continue;
    const auto fields = fields_of(line, at);
    // A header names columns; what begins like a number is one that is spelled wrongly.
    const bool is_header =
        is_first && std::ranges::none_of(fields, [](std::string_view f) {
          return f.empty() || f.find_first_of("0123456789.+-") == 0 || parse_scalar<double>(f).has_value();
        });
    is_first = false;
    if (is_header) continue;
    points.push_back(point_of(fields, dimension, at));
  }
  if (points.empty()) FileLine{path}.fail("no points");
  return points;
}

// Made when first asked for, so that readers may be added from any file before main.
std::map<std::string, MeshReader, std::less<>>& readers() {
  static std::map<std::string, MeshReader, std::less<>> instance{{".obj", mesh_files::read_obj}};
  return instance;
}

// Rhino writes a triangle as a quad whose last two corners are one. Where fewer than three are left, they stay.
void join_equal_corners(std::vector<int>& face) {
  std::vector<int> corners;
  std::ranges::unique_copy(face, std::back_inserter(corners));
  while (corners.size() > 1 && corners.front() == corners.back()) corners.pop_back();
  if (corners.size() >= 3) face = std::move(corners);
}

}  // namespace

std::string extension_of(const std::filesystem::path& path) {
  return mesh_files::lower_case(path.extension().string());
}

RegisterMeshReader::RegisterMeshReader(std::string_view extension, MeshReader reader) {
  readers().emplace(extension, reader);
}

Mesh read_mesh(const std::filesystem::path& path) {
  const std::string extension = extension_of(path);
  const auto reader = readers().find(extension);
  if (reader == readers().end())
    FileLine{path}.fail(fmt::format(
        "unknown extension \"{}\"; meshes are .obj, .ply, .stl, .off or .vtp, polygons .svg, .geojson, .obj "
        "or .vtp, points also .csv, .xyz or .txt",
        extension));
  Mesh mesh = reader->second(path);
  for (std::vector<int>& face : mesh.faces) join_equal_corners(face);
  return mesh;
}

bool is_text_of_points(const std::filesystem::path& path) {
  const std::string extension = extension_of(path);
  return extension == ".csv" || extension == ".xyz" || extension == ".txt";
}

std::vector<Vec3<double>> read_points(const std::filesystem::path& path, int dimension) {
  if (is_text_of_points(path)) return read_text_points(path, dimension);
  Mesh mesh = read_mesh(path);
  if (dimension == 2) check_plane(mesh, path);
  return std::move(mesh.vertices);
}

void check_plane(const Mesh& mesh, const std::filesystem::path& path) {
  const auto off = std::ranges::find_if(mesh.vertices, [](const Vec3<double>& p) { return p[2] != 0; });
  if (off != mesh.vertices.end())
    FileLine{path}.fail(
        fmt::format("vertex {} (counted from 0): 3D points for a polygon: the third coordinate is {}, "
                    "not 0",
                    off - mesh.vertices.begin(), format_scalar((*off)[2])));
}

}  // namespace cageproof
