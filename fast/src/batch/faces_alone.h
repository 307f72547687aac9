// SPDX-License-Identifier: MIT
// Weights of single faces by the closed form that bounds its own error, for points next to them.
#pragma once

#include "cageproof/closed_form/batch/tables.h"

namespace cageproof::closed_form::batch {

/// Adds twice the mean value weights of the faces that are marked for points, with derivatives, to the sums over the
/// others. \param count of the block's points that are asked for
void add_faces_alone(const Block& block, int lanes, int count);

}  // namespace cageproof::closed_form::batch
