// SPDX-License-Identifier: MIT
#include "cage_text.h"

#include "coordinate_table.h"

#include "cageproof/core/input_error.h"
#include "cageproof/reports/mesh_text.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace cageproof::cli {
namespace {

// Cages are read from other formats, too.
std::vector<std::string_view> extensions_for(int dimension) {
  if (dimension == 2) return {".obj", ".svg", ".vtp"};
  return {".obj", ".ply", ".stl", ".vtp"};
}

Mesh mesh_of(const Cage& cage) {
  Mesh mesh;
  mesh.vertices = cage.vertices();
  mesh.is_flat = cage.dimension() == 2;
  for (const Face& face : cage.faces()) {
    if (mesh.is_flat) mesh.segments.push_back({face.vertices[0], face.vertices[1]});
    else mesh.faces.emplace_back(face.vertices.begin(), face.vertices.begin() + face.size());
  }
  return mesh;
}

// Walls thinner than single precision are flat in STL.
void require_cage_in_single_precision(const std::string& file, const Cage& cage) {
  std::vector<Vec3<double>> vertices = cage.vertices();
  for (Vec3<double>& vertex : vertices)
    for (double& x : vertex) x = static_cast<float>(x);
  try {
    Cage::make(cage.name(), std::move(vertices), cage.faces());
  } catch (const InputError& error) {
    throw InputError(fmt::format("--out {}: in the single precision of STL it is no cage: {}; use .obj, .ply or .vtp",
                                 file, error.what()));
  }
}

std::string text_of(const reports::PartialMeshText& made, const std::string& file) {
  for (const std::string& change : made.changed) fmt::print(stderr, "warning: {}: {}\n", file, change);
  return made.text;
}

}  // namespace

std::string cage_text(const std::string& file, const Cage& cage) {
  const std::string extension = extension_of(file);
  const std::vector<std::string_view> known = extensions_for(cage.dimension());
  if (std::ranges::find(known, extension) == known.end())
    throw InputError(fmt::format("--out {}: {} is written as {}", file,
                                 cage.dimension() == 2 ? "a polygon" : "a cage in space", fmt::join(known, ", ")));
  const Mesh mesh = mesh_of(cage);
  if (extension == ".ply") return reports::ply_text(mesh);
  if (extension == ".stl") require_cage_in_single_precision(file, cage);
  if (extension == ".stl") return text_of(reports::stl_text(mesh), file);
  if (extension == ".svg") return text_of(reports::svg_text(mesh), file);
  if (extension == ".vtp") return vtp_text(CoordinateColumns(), mesh);
  return reports::obj_text(mesh);
}

}  // namespace cageproof::cli
