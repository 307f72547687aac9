// SPDX-License-Identifier: MIT
// Reading cages, meshes and points from files, through libraries (tinyobjloader, VTK).
#pragma once

#include "cageproof/core/cage.h"

#include <filesystem>

namespace cageproof {

/// A mesh as read: nothing validated but that numbers are finite and indices in range.
struct Mesh {
  std::vector<Vec3<double>> vertices;  ///< in file order
  std::vector<std::vector<int>> faces; ///< polygons as in the file; empty for a point set
};

/// Reads OBJ (quads and vertex order kept), PLY, STL (equal vertices merged) or VTP, by extension.
/// \throws InputError naming the file (and line, for text) and the reason: missing, empty, unreadable, unknown extension,
///   no vertices, text where a number belongs, truncated line, non-finite number, fewer than three coordinates, index out of range.
Mesh read_mesh(const std::filesystem::path& path);

/// Reads a mesh and validates it as a cage (faces of 3 or 4 corners).
/// \throws InputError as read_mesh and Cage::make
Cage read_cage(const std::filesystem::path& path, CageOptions options = {});

/// Reads points: the vertices of a mesh file, or a text file (`.csv`, `.xyz`, `.txt`) with three numbers a line, separated by commas or
/// blanks; `#` starts a comment, one non-numeric first line is a header.
/// \throws InputError as read_mesh; a line with two numbers is named
std::vector<Vec3<double>> read_points(const std::filesystem::path& path);

}  // namespace cageproof
