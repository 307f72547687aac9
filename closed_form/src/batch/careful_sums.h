// SPDX-License-Identifier: MIT
// The definitions of careful_entries.h, once for each instruction set.
#pragma once

#include "careful.h"
#include "careful_entries.h"

namespace cageproof::closed_form::batch::CAGEPROOF_SIMD {

long careful_bytes(int columns) { return columns * static_cast<long>(sizeof(Pair)); }

void sum_marked(Block& block) {
  auto* const columns = static_cast<Pair*>(block.scratch);
  if (block.layers == Layers::Kelvin) return sum_marked_faces<Layers::Kelvin, 0>(block, columns);
  const bool biharmonic = block.layers == Layers::Biharmonic;
  switch (block.order) {
    case 0:
      return biharmonic ? sum_marked_faces<Layers::Biharmonic, 0>(block, columns)
                        : sum_marked_faces<Layers::Harmonic, 0>(block, columns);
    case 1:
      return biharmonic ? sum_marked_faces<Layers::Biharmonic, 1>(block, columns)
                        : sum_marked_faces<Layers::Harmonic, 1>(block, columns);
    default:
      return biharmonic ? sum_marked_faces<Layers::Biharmonic, 2>(block, columns)
                        : sum_marked_faces<Layers::Harmonic, 2>(block, columns);
  }
}

}  // namespace cageproof::closed_form::batch::CAGEPROOF_SIMD
