// SPDX-License-Identifier: MIT
// Cages of what mesh files hold.
#include "cageproof/core/cage/mesh_io.h"

#include "ears.h"
#include "mesh_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

namespace cageproof {
namespace {

using mesh_files::FileLine;

[[noreturn]] void fail_mixed(const Mesh& mesh, const std::filesystem::path& path) {
  const auto place = [](const std::vector<std::size_t>& lines) {
    return lines.empty() ? "" : fmt::format(" (the first in line {})", lines.front());
  };
  FileLine{path}.fail(
      fmt::format("{} faces{} and {} segments of polylines{}: a cage has faces, in space, or polylines, in the plane",
                  mesh.faces.size(), place(mesh.face_lines), mesh.segments.size(), place(mesh.segment_lines)));
}

// "face 3 (line 12)", or "face 3" where no lines are known.
std::string label_of(const Mesh& mesh, std::size_t face) {
  const std::string line = face < mesh.face_lines.size() ? fmt::format(" (line {})", mesh.face_lines[face]) : "";
  const int number = mesh.face_numbers.empty() ? static_cast<int>(face) : mesh.face_numbers[face];
  return fmt::format("face {}{}", number, line);
}

void cut_polygons(Mesh& mesh, const std::filesystem::path& path) {
  std::vector<std::vector<int>> faces;
  std::vector<std::size_t> lines;
  std::vector<int> numbers;
  std::string first;
  std::size_t count = 0;
  double work = 0;
  const auto add = [&](std::size_t from, std::vector<int> face) {
    faces.push_back(std::move(face));
    if (from < mesh.face_lines.size()) lines.push_back(mesh.face_lines[from]);
    numbers.push_back(mesh.face_numbers.empty() ? static_cast<int>(from) : mesh.face_numbers[from]);
  };
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
    const std::vector<int>& polygon = mesh.faces[f];
    if (polygon.size() <= 4) {
      add(f, polygon);
      continue;
    }
    std::vector<Vec3<double>> corners;
    corners.reserve(polygon.size());
    for (const int v : polygon) corners.push_back(mesh.vertices[v]);
    // Cutting takes the square of the number of corners.
    constexpr double most = 2e8;
    work += static_cast<double>(polygon.size()) * static_cast<double>(polygon.size());
    if (work > most)
      FileLine{path}.fail(fmt::format(
          "{}: {} corners: cutting the faces up to here in triangles takes too long; triangulate them in the program "
          "that wrote the file (faces counted from 0)",
          label_of(mesh, f), polygon.size()));
    const auto triangles = ears_of(corners);
    if (triangles.empty())
      FileLine{path}.fail(fmt::format(
          "{}: {} corners, and a boundary that crosses or touches itself or has no area, so that it cannot be cut in "
          "triangles (faces and vertices counted from 0)",
          label_of(mesh, f), polygon.size()));
    for (const auto& t : triangles) add(f, {polygon[t[0]], polygon[t[1]], polygon[t[2]]});
    if (count++ == 0) first = label_of(mesh, f);
  }
  if (count == 0) return;
  mesh.warnings.push_back(fmt::format("{}: {} faces of more than 4 corners are cut in triangles, the first of them {}",
                                      path.string(), count, first));
  mesh.faces = std::move(faces);
  mesh.face_lines = std::move(lines);
  mesh.face_numbers = std::move(numbers);
}

// The boundary of faces that lie in the plane, as polylines that have the faces on their left.
void take_boundary(Mesh& mesh, const std::filesystem::path& path) {
  std::set<std::pair<int, int>> edges;
  double area = 0;
  const auto for_each_edge = [&](const auto& f) {
    for (std::size_t face = 0; face < mesh.faces.size(); ++face) {
      const std::vector<int>& corners = mesh.faces[face];
      for (std::size_t k = 0; k < corners.size(); ++k) f(face, corners[k], corners[(k + 1) % corners.size()]);
    }
  };
  for_each_edge([&](std::size_t face, int from, int to) {
    if (!edges.insert({from, to}).second)
      FileLine{path}.fail(
          fmt::format("{}: another face runs the same way from vertex {} to {}: the faces of this flat mesh are turned "
                      "differently (faces and vertices counted from 0)",
                      label_of(mesh, face), from, to));
    const Vec3<double>&p = mesh.vertices[from], &q = mesh.vertices[to];
    area += p[0] * q[1] - q[0] * p[1];
  });
  std::set<int> inside, on_boundary;
  for_each_edge([&](std::size_t face, int from, int to) {
    inside.insert(from);
    if (edges.contains({to, from})) return;
    mesh.segments.push_back(area < 0 ? std::array{to, from} : std::array{from, to});
    if (face < mesh.face_lines.size()) mesh.segment_lines.push_back(mesh.face_lines[face]);
    on_boundary.insert({from, to});
  });
  std::erase_if(inside, [&](int v) { return on_boundary.contains(v); });
  if (!inside.empty())
    FileLine{path}.fail(fmt::format(
        "vertex {} (counted from 0) lies within a flat mesh: a cage in the plane is the polygon of its boundary, and "
        "has no vertices inside; dissolve them, or write the boundary as polylines (`l` lines of an OBJ)",
        *inside.begin()));
  mesh.faces.clear();
  mesh.face_lines.clear();
  mesh.face_numbers.clear();
  mesh.warnings.push_back(
      fmt::format("{}: all z are 0: the cage is the polygon of the mesh's boundary, {} segments, in the plane",
                  path.string(), mesh.segments.size()));
}

}  // namespace

Mesh as_cage_mesh(Mesh mesh, const std::filesystem::path& path) {
  if (!mesh.segments.empty()) mesh_files::leave_out_heights(mesh, path);
  if (mesh.faces.empty() || !mesh.segments.empty()) return mesh;
  if (std::ranges::all_of(mesh.vertices, [](const Vec3<double>& p) { return p[2] == 0; })) take_boundary(mesh, path);
  else cut_polygons(mesh, path);
  return mesh;
}

Cage read_cage(const std::filesystem::path& path, CageOptions options) {
  return cage_from(read_mesh(path), path, std::move(options));
}

Cage cage_from(Mesh given, const std::filesystem::path& path, CageOptions options) {
  Mesh mesh = as_cage_mesh(std::move(given), path);
  if (!mesh.segments.empty()) {
    if (!mesh.faces.empty()) fail_mixed(mesh, path);
    std::vector<Face> segments;
    segments.reserve(mesh.segments.size());
    for (const auto& [from, to] : mesh.segments) segments.push_back({{from, to, -1, -1}});
    options.face_lines = std::move(mesh.segment_lines);
    return Cage::make_polygon(path.string(), std::move(mesh.vertices), std::move(segments), std::move(options));
  }
  if (mesh.faces.empty()) FileLine{path}.fail("no faces, and no polylines");
  std::vector<Face> faces;
  for (const std::vector<int>& polygon : mesh.faces) {
    if (polygon.size() < 3)
      FileLine{path}.fail(
          fmt::format("{}: {} corners, a cage's faces have at least 3 (faces and vertices counted from 0)",
                      label_of(mesh, faces.size()), polygon.size()));
    std::ranges::copy(polygon, faces.emplace_back().vertices.begin());
  }
  options.face_lines = std::move(mesh.face_lines);
  options.face_numbers = std::move(mesh.face_numbers);
  return Cage::make(path.string(), std::move(mesh.vertices), std::move(faces), std::move(options));
}

}  // namespace cageproof
