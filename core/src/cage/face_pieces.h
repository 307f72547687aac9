// SPDX-License-Identifier: MIT
// Faces as triangles for tests of where a surface lies.
#pragma once

#include "cageproof/core/cage/cage.h"
#include "cageproof/core/geometry/element.h"

namespace cageproof {

/// Vertices of triangles.
using Pieces = std::vector<std::array<int, 3>>;

/// Whether a diagonal cuts a quad in two triangles of which one is turned against both: it lies outside a planar quad
/// that is concave.
bool folds(const std::vector<Vec3<double>>& vertices, const Face& face, const ElementSplit& split);

/// How a quad is cut: along its shorter diagonal, or at its first corner, but along the other one where that folds it
/// and the other does not.
const ElementSplit& split_of(const std::vector<Vec3<double>>& vertices, const Face& face, Triangulation rule);

/// A face's triangles. A quad is cut by the diagonal at its first corner, or by the other one where that folds it, as
/// in an arrowhead. Triangles without area are left out.
Pieces pieces_of(const std::vector<Vec3<double>>& vertices, const Face& face);

/// The triangles of a quad by every diagonal that does not fold it, planar ones too: what touches a diagonal touches no
/// edge. None for a quad that each diagonal folds.
Pieces all_pieces_of(const std::vector<Vec3<double>>& vertices, const Face& face);

}  // namespace cageproof
