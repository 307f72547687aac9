// SPDX-License-Identifier: MIT
// What makes a cage valid, one check a function. Each throws InputError naming the first face or vertex at fault.
#pragma once

#include "cageproof/core/cage.h"

namespace cageproof::cage_checks {

/// The parts of a cage that is not yet one.
struct Candidate {
  const std::string& name;
  const std::vector<Vec3<double>>& vertices;
  const std::vector<Face>& faces;
  int least_corners = 3;  ///< that a face must have
};

/// Vertices and faces there are, all coordinates finite.
void check_coordinates(const Candidate& cage);
/// Indices in range, none twice in a face, every vertex in a face.
void check_indices(const Candidate& cage);
/// No edge of length zero, no triangle of area zero in any split of a face, no quad that crosses itself; triangles
/// alone where quads may be invalid.
void check_shapes(const Candidate& cage, bool allow_invalid_quads);
/// Every edge between two faces that run along it in opposite directions.
void check_edges(const Candidate& cage);
/// The faces around every vertex form one fan. \pre check_edges passed
void check_fans(const Candidate& cage);
/// A polygon's vertices lie in the plane z = 0.
void check_plane(const Candidate& cage);
/// A polygon's segments have a length, and one begins and one ends at every vertex.
void check_loops(const Candidate& cage);
/// The sign of the area that a polygon encloses, 1 or -1. \throws InputError when it is zero
int turning(const Candidate& cage);
/// The sign of the enclosed volume, 1 or -1. \throws InputError when it is zero
int orientation(const Candidate& cage);

}  // namespace cageproof::cage_checks
