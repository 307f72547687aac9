// SPDX-License-Identifier: MIT
// Cages and meshes of a folder.
#pragma once

#include "deformer_benchmarks.h"

#include <filesystem>

namespace cageproof::benchmarks {

/// The cages X_Cage.obj of a folder that have a mesh X.obj next to them, by name: X, its points the mesh's vertices,
/// posed as X_Cage_Deformed.obj says or, where there is none, as it is.
/// \throws InputError where the folder is none or has no such pair, and as read_cage and read_points
std::vector<std::shared_ptr<const DeformedCage>> cages_in(const std::filesystem::path& folder);

}  // namespace cageproof::benchmarks
