// SPDX-License-Identifier: MIT
// What captions of figures state.
#pragma once

#include "cageproof/core/mesh_io.h"

namespace cageproof::validation {

/// The volume within faces, or, of a mesh in the plane, the area; what is inside out counts as negative.
double content_of(const Mesh& mesh, const std::vector<Vec3<double>>& vertices, int dimension);

/// Whether faces have an inside: each edge of one is that of another the other way round.
bool is_closed(const Mesh& mesh);

/// How far images are from being symmetric in x, where the points are: the largest distance between the image of a
/// point's mirror image and the mirror image of its image. \throws std::invalid_argument for points that are not
/// symmetric
double asymmetry(const std::vector<Vec3<double>>& points, const std::vector<Vec3<double>>& images);

}  // namespace cageproof::validation
