// SPDX-License-Identifier: MIT
// The definitions of careful_entries.h, once for each instruction set.
#pragma once

#include "careful.h"
#include "careful_entries.h"
#include "fine_heights.h"

namespace cageproof::closed_form::batch::CAGEPROOF_SIMD {

long careful_bytes(int columns) { return columns * static_cast<long>(sizeof(Pair)); }

void sum_marked(Block& block) {
  auto* const columns = static_cast<Pair*>(block.scratch);
  with_layers(block.layers, block.order, [&]<Layers L, int O> { sum_marked_faces<L, O>(block, columns); });
}

}  // namespace cageproof::closed_form::batch::CAGEPROOF_SIMD
