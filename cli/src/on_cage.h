// SPDX-License-Identifier: MIT
// The option --on: points that lie outside a cage by a rounding count as on it.
#pragma once

#include "command_line.h"

#include "cageproof/core/coordinates/coordinates.h"

namespace cageproof::cli {

/// Adds the option. \param on a share of the cage's size
void add_on(Command command, double& on);

/// Moves points that are outside by no more than that share of the cage's size onto it, and says how many and how far
/// on standard error. Nothing for a share of zero. \param size of the cage
void take_onto_cage(double on, const CageCoordinates& coordinates, double size, std::vector<Vec3<double>>& points,
                    int jobs);

}  // namespace cageproof::cli
