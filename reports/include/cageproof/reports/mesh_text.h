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

}  // namespace cageproof::reports
