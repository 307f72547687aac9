// SPDX-License-Identifier: MIT
// A change of a cage's vertices that keeps nothing, to take derivatives along.
#pragma once

#include "cageproof/core/cage/cage.h"

#include <vector>

namespace cageproof::validation {

/// Each vertex by up to one cage size along each axis: a function of the cage's name and the vertex's number.
std::vector<Vec3<double>> generic_change(const Cage& cage);

}  // namespace cageproof::validation
