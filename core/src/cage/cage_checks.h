// SPDX-License-Identifier: MIT
// Checks that a cage is valid, one per function. Each throws InputError naming the first face or vertex at fault.
#pragma once

#include "cageproof/core/cage/cage.h"

#include <span>

namespace cageproof::cage_checks {

/// The parts of a cage that is not yet one.
struct Candidate {
  const std::string& name;
  const std::vector<Vec3<double>>& vertices;
  const std::vector<Face>& faces;
  const CageOptions& options;  ///< whose face_lines and face_numbers messages have
  int least_corners = 3;       ///< that a face must have
};

/// Whether it is a polygon.
inline bool is_plane(const Candidate& cage) { return cage.least_corners == 2; }

/// "face 3 (line 12)", or "face 3" where no lines are known; "segment 3" in the plane.
std::string face_label(const Candidate& cage, std::size_t face);

/// \throws InputError "name: reason"
[[noreturn]] void fail(const Candidate& cage, const std::string& reason);
/// fail(), with a reason that names the face, or the vertex, and says how they are counted.
[[noreturn]] void fail_face(const Candidate& cage, std::size_t face, const std::string& reason);
[[noreturn]] void fail_vertex(const Candidate& cage, std::size_t vertex, const std::string& reason);

/// Vertices and faces there are, all coordinates finite.
void check_coordinates(const Candidate& cage);
/// Indices in range, none twice in a face, every vertex in a face.
void check_indices(const Candidate& cage);
/// No edge of length zero, no triangle of area zero in any split of a face, no quad that crosses itself; only triangles
/// are checked where quads may be invalid.
void check_shapes(const Candidate& cage, bool allow_invalid_quads);
/// Every edge is run along by as many faces one way as the other (one, or several where parts of the surface meet), and
/// no face exists twice.
void check_edges(const Candidate& cage);
/// The sign of the volume that closed faces enclose: 1, -1, or 0 for none. In the plane, see polygon_checks.h.
int orientation(const Candidate& cage, std::span<const int> faces);

}  // namespace cageproof::cage_checks
