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
      {};                              ///< one per face; empty where the file has no lines, or the reader tells none
  std::vector<int> face_numbers = {};  ///< as CageOptions::face_numbers
  std::vector<std::array<int, 2>> segments = {};  ///< of polylines, from vertex to vertex, in file order
  std::vector<std::size_t> segment_lines = {};    ///< one per segment, as face_lines
  std::vector<std::string> warnings = {};         ///< "file: what was left out", for people to read
  bool is_flat = false;                           ///< points are written with two coordinates
  std::size_t first_height = 0;  ///< the line of the first third coordinate that is a height over a map; 0 for none
};

/// The extension of a file's name, in lower case: ".obj".
std::string extension_of(const std::filesystem::path& path);

/// Reads the meshes of one extension (".ply"), throwing what read_mesh says.
using MeshReader = Mesh (*)(const std::filesystem::path& path);

/// Adds a reader at program start: `const RegisterMeshReader r{...};` at namespace scope of a .cpp. OBJ is core's own;
/// the library cageproof_mesh_readers adds STL and OFF, PLY and VTP, for which it needs VTK, SVG (libxml2), GeoJSON
/// (nlohmann-json) and points of `.npz` (libarchive).
struct RegisterMeshReader {
  RegisterMeshReader(std::string_view extension, MeshReader reader);
};

/// Reads OBJ, PLY, STL (equal vertices merged), OFF, VTP, SVG or GeoJSON, by extension in any case; polygons and vertex
/// order are kept, but consecutive equal corners of a face become one where three are left. Coordinates are correctly
/// rounded to double, except that STL is single precision, and that an OBJ vertex with a weight w is x/w, y/w, z/w.
/// Relative OBJ indices count back from the last vertex; materials, colours, normals and texture coordinates are
/// ignored. It redirects VTK's messages, so one call at a time. Polylines are read from OBJ (`l`), VTP, SVG (subpaths
/// of straight edges, `polygon`, `polyline` and `rect`, with all transforms applied and y turned up) and GeoJSON (rings
/// and line strings). Shapes of SVG that display or visibility hides, and points and open lines of GeoJSON beside
/// polygons, are left out, with a warning.
/// \throws InputError naming the file (and line, for OBJ, OFF, text PLY and STL, SVG and GeoJSON) and the reason:
///   missing, a directory, empty, unreadable, a Git LFS pointer, unknown extension, no vertices, text where a number
///   belongs, truncated line or file, non-finite number, fewer than three coordinates (two, in an OBJ file of polylines
///   alone), a weight of zero, index out of range; triangle strips (PLY, VTP); binary OFF; a PLY face of more than 255
///   corners; SVG's curves, arcs, text, `use`, unknown elements and transforms; JSON that is no GeoJSON geometry, an
///   open ring
Mesh read_mesh(const std::filesystem::path& path);

/// A mesh as cages are made of: faces of more than four corners are cut in triangles, a mesh whose vertices all have
/// z = 0 becomes the polylines of its boundary, and heights of GeoJSON are left out; each with a warning.
/// \throws InputError naming the face that crosses itself, or, of a flat mesh, the face that is turned otherwise or the
///   vertex that is not on the boundary
Mesh as_cage_mesh(Mesh mesh, const std::filesystem::path& path);

/// Reads a mesh and validates it as a cage: of as_cage_mesh's faces in space, of polylines in the plane.
/// \throws InputError as read_mesh, Cage::make and Cage::make_polygon, and for a file with both faces and polylines
Cage read_cage(const std::filesystem::path& path, CageOptions options = {});

/// Validates a mesh that read_mesh gave of `path` as a cage. \throws InputError as read_cage
Cage cage_from(Mesh mesh, const std::filesystem::path& path, CageOptions options = {});

/// Reads points: the vertices of a mesh file, an array of NumPy's of shape (points, 3) or, in the plane, (points, 2)
/// (`.npy`; `.npz` with one array), or text (`.csv`, `.tsv`, `.xyz`, `.pts`, `.txt`). A file without extension, and
/// standard input ("-"), is text, or an array where it begins as one. Text has one point per line: 3 numbers (decimal
/// or hexadecimal) between semicolons, commas, or blanks and tabs. `#` starts a comment; a first line without any
/// number names the columns; one with a single whole number says how many points follow. More than three columns are
/// taken for x, y, z and others, which are left out, with a warning; named columns are taken by the names x, y, z.
/// \param dimension in the plane, 2, a point may have two numbers, and third coordinates must be zero; heights of
///   GeoJSON are left out, with a warning
/// \throws InputError as read_mesh; naming the line (of a mesh the vertex, of an array the row): too few numbers,
///   another number of columns than in the first point, another number of points than announced, decimal commas, a
///   point that does not lie in the plane; an array of another type or shape, several arrays in one file
std::vector<Vec3<double>> read_points(const std::filesystem::path& path, int dimension = 3);

/// Reads points as read_points(), with the file's faces or polylines, and warnings.
Mesh read_points_and_faces(const std::filesystem::path& path, int dimension = 3);

/// The vertices of a mesh lie in the plane. \throws InputError naming the file and the first vertex that does not
void check_plane(const Mesh& mesh, const std::filesystem::path& path);

}  // namespace cageproof
