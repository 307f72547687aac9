// SPDX-License-Identifier: MIT
// Elastic bodies in cages in space ([C23] Sections 3 and 4.2), by boundary elements.
#pragma once

#include "cageproof/core/coordinates/coordinates.h"

namespace cageproof::solved {

/// Times that triangles are split in four where nobody says how often.
inline constexpr int default_elastic_level = 1;

/// Prepares their coordinates, a 3 x 3 matrix per vertex: displacements affine on the cage's triangles, tractions
/// constant on each of the 4^level pieces of a triangle, from Somigliana's identity at the pieces' centroids.
/// \param nu Poisson's ratio, in (-1, 1/2) \param level 0, 1, ...
/// \throws InputError for cages with too many pieces, or that overlap themselves, or with walls that are too thin for
/// their pieces, and where the system takes more than half of the memory
std::shared_ptr<const PreparedCoordinates> prepare_elastic_in_space(const Cage& cage, const CoordinateOptions& options,
                                                                    double nu, int level);

/// Why a cage's pieces at default_elastic_level are too many; empty where they are not.
std::string why_elastic_is_too_large(const Cage& cage);

}  // namespace cageproof::solved
