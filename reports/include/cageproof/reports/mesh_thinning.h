// SPDX-License-Identifier: MIT
// Meshes with fewer faces, for pictures.
#pragma once

#include "cageproof/core/mesh_io.h"

namespace cageproof::reports {

/// A mesh of triangles with about so many vertices at most, which are vertices of the mesh itself; the topology is
/// kept, which may leave more. Smaller meshes stay as they are. \pre indices in range
Mesh thinned(const Mesh& mesh, std::size_t vertices);

}  // namespace cageproof::reports
