// SPDX-License-Identifier: MIT
// Reading cages, meshes and points from files.
#pragma once

#include "cageproof/core/cage/cage.h"

#include <filesystem>

namespace cageproof {

/// A mesh as read: nothing validated but that numbers are finite and indices in range.
struct Mesh {
  std::vector<Vec3<double>> vertices;   ///< in file order
  std::vector<std::vector<int>> faces;  ///< polygons as in the file; empty for a point set
  std::vector<std::size_t> face_lines =
      {};  ///< one a face; empty where the file has no lines, or the reader tells none
  std::vector<std::array<int, 2>> segments = {};  ///< of polylines, from vertex to vertex, in file order
  std::vector<std::size_t> segment_lines = {};    ///< one a segment, as face_lines
  std::vector<std::string> warnings = {};         ///< what was left out of the file, which they name
};

/// The extension of a file's name, in lower case: ".obj".
std::string extension_of(const std::filesystem::path& path);

/// Reads the meshes of one extension (".ply"), throwing what read_mesh says.
using MeshReader = Mesh (*)(const std::filesystem::path& path);

/// Adds a reader at program start: `const RegisterMeshReader r{...};` at namespace scope of a .cpp. OBJ is core's own;
/// the library cageproof_mesh_readers adds STL and OFF, PLY and VTP, for which it needs VTK, SVG (libxml2) and GeoJSON
/// (nlohmann-json).
struct RegisterMeshReader {
  RegisterMeshReader(std::string_view extension, MeshReader reader);
};

/// Reads OBJ, PLY, STL (equal vertices merged), OFF, VTP, SVG or GeoJSON, by extension in any case; polygons and vertex
/// order are kept, but consecutive equal corners of a face become one where three are left. Coordinates are correctly
/// rounded to double, except that STL is single precision, and that an OBJ vertex with a weight w is x/w, y/w, z/w.
/// Relative OBJ indices count back from the last vertex; materials, colours, normals and texture coordinates are
/// ignored. It redirects VTK's messages, so one call at a time. Polylines are read from OBJ (`l`), VTP, SVG (subpaths
/// of straight edges, `polygon`, `polyline` and `rect`, with all transforms applied and y turned up) and GeoJSON (rings
/// and line strings).
/// \throws InputError naming the file (and line, for OBJ, OFF, text PLY and STL, SVG and GeoJSON) and the reason:
///   missing, a directory, empty, unreadable, a Git LFS pointer, unknown extension, no vertices, text where a number
///   belongs, truncated line or file, non-finite number, fewer than three coordinates (two, in an OBJ file of polylines
///   alone), a weight of zero, index out of range; triangle strips (PLY, VTP); binary OFF; a PLY face of more than 255
///   corners; what of SVG is neither polygon nor without a shape: curves, arcs, text, `use`, an unknown element or
///   transform; what is no GeoJSON geometry, an open ring
Mesh read_mesh(const std::filesystem::path& path);

/// A mesh as cages are made of: faces of more than four corners are cut in triangles, and a mesh whose vertices all
/// have z = 0 becomes the polylines of its boundary; either with a warning. \throws InputError naming the face that
/// crosses itself, or, of a flat mesh, the face that is turned otherwise or the
///   vertex that is not on the boundary
Mesh as_cage_mesh(Mesh mesh, const std::filesystem::path& path);

/// Reads a mesh and validates it as a cage: of as_cage_mesh's faces in space, of polylines in the plane.
/// \throws InputError as read_mesh, Cage::make and Cage::make_polygon, and for a file with both faces and polylines
Cage read_cage(const std::filesystem::path& path, CageOptions options = {});

/// Validates a mesh that read_mesh gave of `path` as a cage. \throws InputError as read_cage
Cage cage_from(Mesh mesh, const std::filesystem::path& path, CageOptions options = {});

/// Whether the file is text of points (`.csv`, `.xyz`, `.txt`), by its extension.
bool is_text_of_points(const std::filesystem::path& path);

/// Reads points: the vertices of a mesh file, or a text file with exactly three numbers a line (decimal or
/// hexadecimal), separated by commas or blanks; `#` starts a comment, a first line without any number is a header.
/// \param dimension in the plane, 2, text may have two numbers a line, and third coordinates must be zero
/// \throws InputError as read_mesh; a line with too few or too many numbers is named, and a line, of a mesh a vertex,
///   with a point that does not lie in the plane
std::vector<Vec3<double>> read_points(const std::filesystem::path& path, int dimension = 3);

/// The vertices of a mesh lie in the plane. \throws InputError naming the file and the first vertex that does not
void check_plane(const Mesh& mesh, const std::filesystem::path& path);

}  // namespace cageproof
