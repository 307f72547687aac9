// SPDX-License-Identifier: MIT
// Cages that overlap themselves, on which no densities can be solved for.
#pragma once

#include "cageproof/core/cage/cage.h"

namespace cageproof::deformation {

/// Why densities cannot be solved for on a cage that overlaps itself: it names faces that cross, and one that lies
/// within the cage, where Green coordinates do not sum to one. Empty where they sum to one at all samples of either
/// triangulation, as on a cage whose faces only touch.
std::string why_overlap_is_refused(const Cage& cage);

/// The same of deformers that keep quads, after what all of these refuse (kept_quads.h).
std::string why_kept_overlap_is_refused(const Cage& cage);

}  // namespace cageproof::deformation
