// SPDX-License-Identifier: MIT
// Faces of a surface that cross each other.
#pragma once

#include "cageproof/core/cage/cage.h"

namespace cageproof {

/// Two faces, counted from 0, that meet in more than the vertices and edges that they share.
struct FaceCrossing {
  int first, second;
  auto operator<=>(const FaceCrossing&) const = default;
};

/// All pairs of faces that cross or touch away from their common vertices and edges, in rising order, decided exactly
/// (CGAL). A quad is its two triangles: of a planar one the two that cover it, of a twisted one those by either
/// diagonal that does not fold it, between which the bilinear surface lies. A face is not tested against itself, and a
/// quad that either diagonal folds not at all. \pre indices in range, triangles have an area
/// \throws InputError for more than 300000 pairs, which take gigabytes and minutes and are no accident of a surface
std::vector<FaceCrossing> face_crossings(const std::vector<Vec3<double>>& vertices, const std::vector<Face>& faces);

}  // namespace cageproof
