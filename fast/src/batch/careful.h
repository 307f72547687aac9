// SPDX-License-Identifier: MIT
// Sums over the faces that points are next to, in double-doubles, for one instruction set. The geometry is exact up to
// their rounding, so that angles next to an edge are those of the point itself.
#pragma once

#include "cageproof/closed_form/batch/pair.h"

#include "seen_face.h"

namespace cageproof::closed_form::batch::CAGEPROOF_SIMD {

/// kNextToEdge and kNextToFace for double-doubles, by the highest derivative that is asked for: heights that are powers
/// of 1e-31 of the face enter Hessians squared.
inline constexpr double kBeyondEdge[3] = {0x1p-40, 0x1p-36, 0x1p-20};
inline constexpr double kBeyondFace = 0x1p-70;
/// kBeyondFace for distances from corners.
inline constexpr double kLeast = 0x1p-160;

template <Layers L, int O>
void sum_marked_faces(Block& block, Pair* columns) {
  const CageTables& cage = *block.cage;
  const Sums<Pair> sums{columns, &block.layout};
  const auto* const point = reinterpret_cast<const Lanes*>(block.points);
  const Pair beta(block.beta);
  for (int c = 0; c < block.layout.count; ++c) columns[c] = Pair();
  block.beyond_marked = 0;
  for (int m = 0; m < block.marked; ++m) {
    const Mark mark = block.marks[m];
    const FaceTable<TwoDoubles>& face = cage.fine_face[mark.face];
    SeenFace<L, O, Pair, TwoDoubles> seen(
        face, [&](int e) -> const auto& { return cage.fine_edge[face.edge[e]]; },
        [&](int k, int i) { return exact_sum(splat(cage.vertex[3 * face.vertex[k] + i]), -point[i]); });
    const Pair omega = Pair(2.0) * angle_of(seen.across, seen.along);
    const Lanes high = magnitude(seen.across.high), wide = magnitude(seen.along.high);
    const Lanes edge_limit = kBeyondEdge[O] * seen.product.high;
    // Quotients 0/0 are undecided as well, and distances whose powers leave double's range.
    const Mask decided = ((high > edge_limit) | (wide > edge_limit)) &
                         ((seen.along.high > Lanes{}) | (high > kBeyondFace * wide)) & (seen.r[0].high > kLeast) &
                         (seen.r[1].high > kLeast) & (seen.r[2].high > kLeast);
    Mask mine;
    unsigned beyond = 0;
    for (int i = 0; i < kLanes; ++i) {
      const bool asked = (mark.points >> i & 1u) != 0;
      mine[i] = asked && decided[i] != 0 ? -1 : 0;
      if (asked && decided[i] == 0) beyond |= 1u << i;
    }
    if (beyond != 0) block.beyond[block.beyond_marked++] = {mark.face, beyond};
    for (auto& edge : seen.edge) edge = without(~mine, edge);
    seen.add(face, mark.face, select(mine, omega, Pair()), beta, sums);
  }
  auto* const to = reinterpret_cast<Lanes*>(block.columns);
  for (int c = 0; c < block.layout.count; ++c) to[c] += columns[c].high + columns[c].low;
}

}  // namespace cageproof::closed_form::batch::CAGEPROOF_SIMD
