// SPDX-License-Identifier: MIT
// What a mesh file has beside places: taken along where its vertices move, or named where it is left out.
#pragma once

#include "cageproof/core/numbers/vector.h"
#include "cageproof/core/results/run_result.h"

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

/// A PLY file with its vertices elsewhere, in doubles. Comments, the format, all other properties and elements stay;
/// properties nx, ny and nz of vertices are left out. \param vertices as many as the text has
/// \throws InputError where these numbers differ, or the text is no whole PLY file
CarriedMesh ply_with_vertices(std::string_view text, std::span<const Vec3<double>> vertices);

/// A VTP file with its vertices elsewhere, in doubles. Cells of all kinds and arrays stay, but normals, which are left
/// out, and arrays with the names of `moved`'s, which take their place.
/// \param moved vertices, as many as the text has, and arrays of these \throws InputError where these numbers differ
CarriedMesh vtp_with_vertices(std::string_view text, const MeshField& moved);

/// Names what a mesh file (OBJ, PLY, VTP) has beside vertices, faces and polylines, each once: "texture coordinates",
/// "property red", "array temperature". Empty for other formats. \throws InputError where it cannot be read
std::vector<std::string> beside_places(const std::filesystem::path& file);

}  // namespace cageproof::reports
