// SPDX-License-Identifier: MIT
// Carries a mesh file's other data along where its vertices move, and names those that are left out.
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
  std::vector<std::string> left_out;       ///< data that depend on places: "normals"
  std::vector<std::string> replaced = {};  ///< data made anew under the same name: "array image [1]"
};

/// An OBJ file with its vertices elsewhere. Texture coordinates, groups, objects, materials, vertex colours, comments
/// and the order of lines stay; normals are left out, and faces no longer refer to them. \param vertices as many as the
/// text has, finite \throws InputError where these numbers differ
CarriedMesh obj_with_vertices(std::string_view text, std::span<const Vec3<double>> vertices);

/// A PLY file with its vertices elsewhere, as doubles, in the format that it has (text, or binary in either order of
/// bytes). Comments, further properties and elements, and their order, stay; normals of vertices and faces (nx, ny, nz)
/// are left out, and so is what stands behind the last element. \param vertices as many as the file has, finite
/// \throws InputError where these numbers differ, and for a file that ends early
CarriedMesh ply_with_vertices(std::string_view text, std::span<const Vec3<double>> vertices);

/// A VTP file with its vertices elsewhere, as doubles. Its cells and arrays of points, cells and the whole stay;
/// normals are left out: what is their attribute, and arrays called Normals. \param images arrays of points that are
/// added \param vertices as many as the file has, finite \throws InputError where these numbers differ
CarriedMesh vtp_with_vertices(const std::filesystem::path& file, std::span<const Vec3<double>> vertices,
                              const MeshField& images);

/// Names what a mesh file (OBJ, PLY, VTP, SVG, STL, GeoJSON) holds that is neither vertex, face nor polyline, each
/// once: "texture coordinates", "property red", "array temperature". Empty for other formats. \throws InputError where
/// it cannot be read
std::vector<std::string> beside_places(const std::filesystem::path& file);

}  // namespace cageproof::reports
