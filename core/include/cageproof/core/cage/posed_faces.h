// SPDX-License-Identifier: MIT
// Whether a posed cage is the rest cage with other places, or numbers its vertices otherwise.
#pragma once

#include "cageproof/core/cage/cage.h"
#include "cageproof/core/cage/mesh_io.h"

#include <optional>
#include <string>

namespace cageproof {

/// Names the first face (in the plane: segment) of a posed cage's mesh that is not the rest cage's, counted from 0,
/// with its line and its vertices; nothing where there is none. Faces count as the same from any corner and in either
/// direction. Where the cage has another number of faces, they may come in any order, triangles count as parts of a
/// quad that has their corners, and a quad or polygon as what such triangles make. A mesh without faces, or with
/// another number of vertices, is not compared.
std::optional<std::string> foreign_face(const Cage& rest, const Mesh& posed);

}  // namespace cageproof
