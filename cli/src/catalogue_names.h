// SPDX-License-Identifier: MIT
// What `list` says of the catalogue, in both its forms.
#pragma once

#include "cageproof/core/coordinates.h"

#include <string>
#include <string_view>
#include <vector>

namespace cageproof::cli {

/// Checks that samples of elements are not asked one by one.
std::vector<std::string_view> other_checks();

/// The blocks of a kind that is no sum, as it has them in a cage of its dimension.
std::vector<CoordinateBlock> own_blocks(const CoordinateKind& kind);

/// What computes a kind at once in a cage of space or of the plane.
std::vector<std::string_view> whole_evaluations_of(const CoordinateKind& kind);

/// All of it as JSON, with scalars, ranges and descriptions.
std::string catalogue_text();

}  // namespace cageproof::cli
