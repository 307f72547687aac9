// SPDX-License-Identifier: MIT
// Harmonic coordinates of triangulated cages (Joshi et al. 2007) by boundary elements.
#pragma once

#include "cageproof/core/coordinates/coordinates.h"

namespace cageproof::solved {

/// Times that triangles are split in four where nobody says how often.
inline constexpr int default_level = 1;

/// Prepares them: values affine on the cage's triangles, normal derivatives affine on each of the 4^level pieces of a
/// triangle, with jumps between pieces, from Green's identity at three places within each piece.
/// \param level 0, 1, ... \throws InputError for cages with too many pieces, or on which Green coordinates do not sum
/// to one
std::shared_ptr<const PreparedCoordinates> prepare_harmonic_in_space(const Cage& cage, const CoordinateOptions& options,
                                                                     int level);

/// Why a cage's pieces at default_level are too many for a system that memory holds; empty where they are not.
std::string why_too_large_in_space(const Cage& cage);

}  // namespace cageproof::solved
