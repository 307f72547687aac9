// SPDX-License-Identifier: MIT
// Meshes with fewer faces, for pictures.
#pragma once

#include "cageproof/core/cage/mesh_io.h"

namespace cageproof::reports {

/// A mesh of triangles with about so many vertices at most, which lie near the mesh, not on it: edges that change its
/// shape least are drawn together first (quadric error metrics, VTK's). Smaller meshes stay as they are.
/// \pre indices in range
Mesh thinned(const Mesh& mesh, std::size_t vertices);

}  // namespace cageproof::reports
