// SPDX-License-Identifier: MIT
// Sums in double-doubles of each instruction set, compiled by themselves: products and sums must not be contracted.
#pragma once

#include "cageproof/closed_form/batch/lanes.h"
#include "cageproof/closed_form/batch/tables.h"

namespace cageproof::closed_form::batch::CAGEPROOF_SIMD {

void sum_marked(Block& block);
long careful_bytes(int columns);
/// The height of each point over the plane of each face, outward: [face].
void fine_heights(const Block& block, Lanes* heights);
/// The heights of a face's edges over each point's projection, outward.
void fine_edge_heights(const Block& block, int f, Lanes (&heights)[3]);

}  // namespace cageproof::closed_form::batch::CAGEPROOF_SIMD
