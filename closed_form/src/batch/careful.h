// SPDX-License-Identifier: MIT
// Sums over the faces that points are next to, in double-doubles, for one instruction set. The geometry is exact up to
// their rounding, so that angles next to an edge are those of the point itself.
#pragma once

#include "pair.h"

#include "face_terms.h"

namespace cageproof::closed_form::batch::CAGEPROOF_SIMD {

/// As kNextToEdge and kNextToFace, for double-doubles, by the derivatives that are asked for: heights that are powers
/// of 1e-31 of the face enter Hessians squared.
inline constexpr double kBeyondEdge[3] = {0x1p-40, 0x1p-36, 0x1p-20};
inline constexpr double kBeyondFace = 0x1p-70;

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
    Three<Pair> x[3];
    Pair r[3];
    for (int k = 0; k < 3; ++k) {
      for (int i = 0; i < 3; ++i) x[k][i] = exact_sum(splat(cage.vertex[3 * face.vertex[k] + i]), -point[i]);
      r[k] = root(dot(x[k], x[k]));
    }
    EdgeTerms<Pair> edge[3];
    for (int e = 0; e < 3; ++e) {
      const int a = face.along[e] > 0 ? e : (e + 1) % 3, b = face.along[e] > 0 ? (e + 1) % 3 : e;
      edge[e] = edge_terms<L, O, Pair, TwoDoubles>(cage.fine_edge[face.edge[e]], x[a], x[b], r[a], r[b]);
    }
    const Pair product = r[0] * r[1] * r[2];
    const Pair across = dot(face.n, x[0]) * face.area2;
    const Pair along = product + edge[0].between * r[2] + edge[1].between * r[0] + edge[2].between * r[1];
    const Pair omega = Pair(2.0) * angle_of(across, along);
    const Lanes high = magnitude(across.high), wide = magnitude(along.high);
    const Lanes edge_limit = kBeyondEdge[O] * product.high;
    // Quotients of nothing are beyond as well.
    const Mask decided =
        ((high > edge_limit) | (wide > edge_limit)) & ((along.high > Lanes{}) | (high > kBeyondFace * wide));
    Mask mine;
    unsigned beyond = 0;
    for (int i = 0; i < kLanes; ++i) {
      const bool asked = (mark.points >> i & 1u) != 0;
      mine[i] = asked && decided[i] != 0 ? -1 : 0;
      if (asked && decided[i] == 0) beyond |= 1u << i;
    }
    if (beyond != 0) block.beyond[block.beyond_marked++] = {mark.face, beyond};
    EdgeTerms<Pair> left[3];
    for (int e = 0; e < 3; ++e) {
      left[e].inverse = select(mine, edge[e].inverse, Pair());
      left[e].distance = select(mine, edge[e].distance, Pair());
      for (int i = 0; i < 3; ++i) {
        left[e].grad_inverse[i] = select(mine, edge[e].grad_inverse[i], Pair());
        left[e].grad_distance[i] = select(mine, edge[e].grad_distance[i], Pair());
        left[e].turning[i] = select(mine, edge[e].turning[i], Pair());
      }
    }
    const Three<Pair>* const corners[3] = {&x[0], &x[1], &x[2]};
    const EdgeTerms<Pair>* const edges[3] = {&left[0], &left[1], &left[2]};
    const FaceTerms<L, O, Pair, TwoDoubles> terms(face, corners, select(mine, omega, Pair()), edges);
    if constexpr (L == Layers::Kelvin) terms.add_kelvin(mark.face, beta, sums);
    else terms.add(mark.face, sums);
  }
  auto* const to = reinterpret_cast<Lanes*>(block.columns);
  for (int c = 0; c < block.layout.count; ++c) to[c] += columns[c].high + columns[c].low;
}

}  // namespace cageproof::closed_form::batch::CAGEPROOF_SIMD
