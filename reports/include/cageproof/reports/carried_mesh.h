// SPDX-License-Identifier: MIT
// What a mesh file has beside places: taken along where its vertices move, or named where it is left out.
#pragma once

#include "cageproof/core/numbers/vector.h"

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace cageproof::reports {

/// A mesh file's text with its vertices elsewhere.
struct CarriedMesh {
  std::string text;
  std::vector<std::string> left_out;  ///< what depends on places: "normals"
};

/// An OBJ file with its vertices elsewhere. Texture coordinates, groups, objects, materials, vertex colours, comments
/// and the order of lines stay; normals are left out, and faces no longer refer to them. \param vertices as many as the
/// text has, finite \throws InputError where these numbers differ
CarriedMesh obj_with_vertices(std::string_view text, std::span<const Vec3<double>> vertices);

/// Names what a mesh file (OBJ, PLY, VTP) has beside vertices, faces and polylines, each once: "texture coordinates",
/// "property red", "array temperature". Empty for other formats. \throws InputError where it cannot be read
std::vector<std::string> beside_places(const std::filesystem::path& file);

}  // namespace cageproof::reports
