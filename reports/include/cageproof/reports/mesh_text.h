// SPDX-License-Identifier: MIT
// Meshes as text of the usual formats.
#pragma once

#include "cageproof/core/cage/mesh_io.h"

#include <string>
#include <vector>

namespace cageproof::reports {

/// Wavefront OBJ: vertices with all digits of a double, faces of any size, polylines. \pre all vertices are finite
std::string obj_text(const Mesh& mesh);

/// A text that cannot hold all of a mesh.
struct PartialMeshText {
  std::string text;
  std::vector<std::string> left_out = {};  ///< "polylines"
  std::vector<std::string> changed = {};   ///< "coordinates are rounded ..."
};

/// Binary STL: triangles with their normals by the right-hand rule, or zero where they have no area, in single
/// precision. Faces of more corners are cut as triangles_of_face does; those that it cannot cut make triangles about
/// their first corner. \pre all vertices are finite \throws InputError for a mesh without faces, for more triangles
/// than STL counts, and naming a vertex of a face that is beyond single precision
PartialMeshText stl_text(const Mesh& mesh);

/// SVG: a path for each polyline, and a vertex of no segment as a polyline of one point, in the order of vertices as
/// far as SVG, which does not number them, can have it; y turned down, shortest decimals that give the same doubles.
/// \pre all vertices are finite and lie in the plane \throws InputError for a mesh without polylines, and for one that
/// is wider than doubles
PartialMeshText svg_text(const Mesh& mesh);

/// Binary PLY, little endian: vertices as doubles, faces of 3 to 255 corners, polylines as edges.
std::string ply_text(const Mesh& mesh);

}  // namespace cageproof::reports
