// SPDX-License-Identifier: MIT
// Cages made in code, so that verification needs no file.
#pragma once

#include "cageproof/core/cage.h"

namespace cageproof {

/// Names of the embedded cages, in report order: cube, icosphere, torus, l-block, twisted-bar, thin-box, spiky-box; in
/// the plane square.
std::vector<std::string_view> embedded_cage_names();

/// The embedded cage of that name.
/// \throws InputError listing the names there are
Cage embedded_cage(std::string_view name);

}  // namespace cageproof
