// SPDX-License-Identifier: MIT
// Heights of points over the planes of faces, rounded once, for one instruction set. Normals in double would turn by a
// rounding, which far along a thin wall, or next to the edge of two faces that lie on each other nearly, is more than a
// rounding of the height. Compile without contraction of products and sums.
#pragma once

#include "pair.h"

namespace cageproof::closed_form::batch::CAGEPROOF_SIMD {

void fine_heights(const Block& block, Lanes* heights) {
  const CageTables& cage = *block.cage;
  const auto* const point = reinterpret_cast<const Lanes*>(block.points);
  for (int f = 0; f < cage.faces; ++f) {
    const FaceTable<TwoDoubles>& face = cage.fine_face[f];
    const double* const corner = cage.vertex + 3 * face.vertex[0];
    Lanes sum{}, rest{};
    for (int i = 0; i < 3; ++i) {
      const Pair x = exact_sum(point[i], splat(-corner[i]));
      const Pair term = exact_product(splat(face.n[i].high), x.high), added = exact_sum(sum, term.high);
      sum = added.high;
      rest += added.low + (term.low + (face.n[i].high * x.low + face.n[i].low * x.high));
    }
    heights[f] = sum + rest;
  }
}

}  // namespace cageproof::closed_form::batch::CAGEPROOF_SIMD
