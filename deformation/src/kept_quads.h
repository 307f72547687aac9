// SPDX-License-Identifier: MIT
// The common part of the deformers that keep quads.
#pragma once

#include "cageproof/deformation/stretch.h"

namespace cageproof::deformation {

/// Why a cage has no deformers that keep quads: a polygon has no quads, and where a quad's corner has no area, normals
/// have no share that could be stretched. Empty where it has.
std::string why_quads_are_refused(const Cage& cage);

/// How long posed normals are, by the stretches' names: of triangulated cages, or of cages whose quads are kept.
KindParameter stretch_parameter(std::string_view name, std::string_view description, Stretch preset, bool keeps_quads);

}  // namespace cageproof::deformation
