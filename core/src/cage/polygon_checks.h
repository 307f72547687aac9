// SPDX-License-Identifier: MIT
// Exact checks that segments make polygons, one per function. Each throws InputError naming the first vertex or segment
// at fault.
#pragma once

#include "cage_checks.h"

namespace cageproof::cage_checks {

/// All elements are segments, all vertices in the plane z = 0.
void check_plane(const Candidate& cage);
/// No segment without length. \pre check_indices passed
void check_lengths(const Candidate& cage);
/// No two vertices of one polyline at one place. \pre check_indices passed
void check_places(const Candidate& cage);
/// Two segments at every vertex: closed loops, which share no vertex. \pre check_indices passed
void check_loops(const Candidate& cage);
/// At every vertex one segment ends and one begins. \pre check_loops passed
void check_directions(const Candidate& cage);
/// No segments that cross or overlap, none of a loop that touch; loops may touch others in points.
/// \pre check_directions, check_lengths and check_places passed
void check_simple(const Candidate& cage);

/// The direction of one loop: 1 counter-clockwise, -1 clockwise. \pre check_directions and check_simple passed
int turning(const Candidate& cage, std::span<const int> loop);

/// Reverses segments so that each loop runs as its first segment does. \pre check_loops passed
void align_segments(std::vector<Face>& segments, std::size_t vertex_count);

}  // namespace cageproof::cage_checks
