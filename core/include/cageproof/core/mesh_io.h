// SPDX-License-Identifier: MIT
// Reading cages, meshes and points from files, through libraries (tinyobjloader, VTK).
#pragma once

#include "cageproof/core/cage.h"

#include <filesystem>

namespace cageproof {

/// A mesh as read: nothing validated but that numbers are finite and indices in range.
struct Mesh {
  std::vector<Vec3<double>> vertices;   ///< in file order
  std::vector<std::vector<int>> faces;  ///< polygons as in the file; empty for a point set
  std::vector<std::size_t> face_lines =
      {};  ///< one a face; empty where the file has no lines, or the reader tells none
};

/// Reads the meshes of one extension (".ply"), throwing what read_mesh says.
using MeshReader = Mesh (*)(const std::filesystem::path& path);

/// Adds a reader at program start: `const RegisterMeshReader r{...};` at namespace scope of a .cpp. OBJ is core's own;
/// the library cageproof_mesh_readers adds PLY, STL and VTP, for which it needs VTK.
struct RegisterMeshReader {
  RegisterMeshReader(std::string_view extension, MeshReader reader);
};

/// Reads OBJ, PLY, STL (equal vertices merged) or VTP, by extension; polygons and vertex order are kept. Coordinates
/// are correctly rounded to double, except that STL is single precision. Relative OBJ indices count back from the last
/// vertex; materials, normals and texture coordinates are ignored. It redirects VTK's messages, so one call at a time.
/// \throws InputError naming the file (and line, for OBJ and text PLY) and the reason: missing, a directory, empty,
///   unreadable, unknown extension, no vertices, text where a number belongs, truncated line or file, non-finite
///   number, fewer than three coordinates, index out of range; triangle strips (VTP); a PLY face of more than 255
///   corners
Mesh read_mesh(const std::filesystem::path& path);

/// Reads a mesh and validates it as a cage (faces of 3 or 4 corners).
/// \throws InputError as read_mesh and Cage::make
Cage read_cage(const std::filesystem::path& path, CageOptions options = {});

/// Reads points: the vertices of a mesh file, or a text file (`.csv`, `.xyz`, `.txt`) with exactly three numbers a line
/// (decimal or hexadecimal), separated by commas or blanks; `#` starts a comment, a first line without any number is a
/// header.
/// \throws InputError as read_mesh; a line with two or four numbers is named
std::vector<Vec3<double>> read_points(const std::filesystem::path& path);

}  // namespace cageproof
