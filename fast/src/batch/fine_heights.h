// SPDX-License-Identifier: MIT
// Heights of points over the planes of faces, rounded once, for one instruction set. Normals in double would turn by a
// rounding, which far along a thin wall, or next to the edge of two faces that lie on each other nearly, is more than a
// rounding of the height. Compile without contraction of products and sums.
#pragma once

#include "cageproof/closed_form/batch/pair.h"

namespace cageproof::closed_form::batch::CAGEPROOF_SIMD {

/// The heights of the points over a plane through a corner, in its normal's direction.
inline Lanes fine_height(const Block& block, const double* corner, const TwoDoubles (&normal)[3]) {
  const auto* const point = reinterpret_cast<const Lanes*>(block.points);
  Lanes sum{}, rest{};
  for (int i = 0; i < 3; ++i) {
    const Pair x = exact_sum(point[i], splat(-corner[i]));
    const Pair term = exact_product(splat(normal[i].high), x.high), added = exact_sum(sum, term.high);
    sum = added.high;
    rest += added.low + (term.low + (normal[i].high * x.low + normal[i].low * x.high));
  }
  return sum + rest;
}

void fine_heights(const Block& block, Lanes* heights) {
  const CageTables& cage = *block.cage;
  for (int f = 0; f < cage.faces; ++f) {
    const FaceTable<TwoDoubles>& face = cage.fine_face[f];
    heights[f] = fine_height(block, cage.vertex + 3 * face.vertex[0], face.n);
  }
}

void fine_edge_heights(const Block& block, int f, Lanes (&heights)[3]) {
  const FaceTable<TwoDoubles>& face = block.cage->fine_face[f];
  for (int e = 0; e < 3; ++e) heights[e] = -fine_height(block, block.cage->vertex + 3 * face.vertex[e], face.nu[e]);
}

}  // namespace cageproof::closed_form::batch::CAGEPROOF_SIMD
