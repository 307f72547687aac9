// SPDX-License-Identifier: MIT
// Whether coordinates that were solved for on pieces meet the data of vertices between the places they were solved at.
#pragma once

#include "refined_surface.h"

#include <string_view>

namespace cageproof::solved {

/// Densities on pieces that are much longer than a wall is thick, or on faces within another part, do not meet the data
/// between the places that were solved for. Next to corners they miss them most.
/// \param coordinates with one block, of vertices \param kind "harmonic" \param data "values"
/// \throws InputError where coordinates next to a corner are off the hat functions by more than `most`
void require_vertices_met(const HasLimits& coordinates, const CoordinateBlock& block, const RefinedSurface& surface,
                          std::string_view cage, std::string_view kind, std::string_view data, double most);

/// Why a cage's triangles have too many unknowns at a level; empty where they have not.
std::string why_too_many_unknowns(const Cage& cage, int densities, int level);

}  // namespace cageproof::solved
