// SPDX-License-Identifier: MIT
#include "cageproof/core/cage/mesh_io.h"

#include "cageproof/core/numbers/scalar_text.h"
#include "mesh_files.h"
#include "points_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <map>

namespace cageproof {
namespace {

using mesh_files::FileLine;

// Made when first asked for, so that readers may be added from any file before main.
std::map<std::string, MeshReader, std::less<>>& readers() {
  static std::map<std::string, MeshReader, std::less<>> instance{{".obj", mesh_files::read_obj},
                                                                 {".npy", mesh_files::read_npy}};
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
        "unknown extension \"{}\"; meshes are .obj, .ply, .stl, .off or .vtp, polygons .svg, .geojson, .json, .obj or "
        ".vtp, points also .npy, .npz, .csv, .tsv, .xyz, .pts or .txt",
        extension));
  Mesh mesh = reader->second(path);
  for (std::vector<int>& face : mesh.faces) join_equal_corners(face);
  return mesh;
}

Mesh read_points_and_faces(const std::filesystem::path& path, int dimension) {
  Mesh mesh = mesh_files::is_text_of_points(path) ? mesh_files::read_text_points(path, dimension) : read_mesh(path);
  if (dimension == 2) {
    mesh_files::leave_out_heights(mesh, path);
    check_plane(mesh, path);
  } else if (mesh.is_flat) {
    FileLine{path}.fail("points have two coordinates, in space they have three");
  }
  return mesh;
}

std::vector<Vec3<double>> read_points(const std::filesystem::path& path, int dimension) {
  return std::move(read_points_and_faces(path, dimension).vertices);
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
