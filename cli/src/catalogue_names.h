// SPDX-License-Identifier: MIT
// What `list` says of the catalogue, in both its forms.
#pragma once

#include "cageproof/core/coordinates/coordinates.h"

#include <string_view>
#include <vector>

namespace cageproof::cli {

/// Checks of whole cages, of neighbouring elements and of deformers.
std::vector<std::string_view> other_checks();

/// The blocks of a kind that is no sum, as it has them in a cage of its dimension.
std::vector<CoordinateBlock> own_blocks(const CoordinateKind& kind);

/// The names of whole evaluations (`batched`) of a kind, in space or in the plane.
std::vector<std::string_view> whole_evaluations_of(const CoordinateKind& kind);

}  // namespace cageproof::cli
