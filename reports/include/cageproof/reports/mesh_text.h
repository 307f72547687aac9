// SPDX-License-Identifier: MIT
// Meshes as text of the usual formats.
#pragma once

#include "cageproof/core/cage/mesh_io.h"

#include <string>

namespace cageproof::reports {

/// Wavefront OBJ: vertices with all digits of a double, faces of any size, polylines. \pre all vertices are finite
std::string obj_text(const Mesh& mesh);

/// Binary PLY, little endian: vertices as doubles, faces of 3 to 255 corners, polylines as edges.
std::string ply_text(const Mesh& mesh);

/// Binary STL with normals by the right-hand rule, zero of triangles without area. Coordinates are rounded to float.
/// \throws InputError naming the first face that is no triangle, or the vertex that is beyond float's range; for a mesh
/// without faces
std::string stl_text(const Mesh& mesh);

/// SVG: a `path` for each polyline, closed ones with `Z`, y turned down, coordinates with all digits.
/// \throws InputError naming the first vertex that is not in the plane z = 0, or belongs to no polyline; for a mesh
/// without polylines
std::string svg_text(const Mesh& mesh);

}  // namespace cageproof::reports
