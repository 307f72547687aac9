// SPDX-License-Identifier: MIT
// Far faces of a block of points by the rules that each point takes, for one instruction set.
#pragma once

#include "far_moments.h"
#include "near_faces.h"

namespace cageproof::closed_form::batch::CAGEPROOF_SIMD {

/// To a vertex.
inline Three<Lanes> from_point(const CageTables& cage, const Lanes* point, int v) {
  Three<Lanes> x;
  for (int i = 0; i < 3; ++i) x[i] = cage.vertex[3 * v + i] - point[i];
  return x;
}

/// Calls add(face, vector to its corner 0, FarMoments) for each far face, once for each rule that points take. Moments
/// of points that take another are zero.
template <Layers L, int O, class Add>
void for_far_faces(const Block& block, const NearFaces& near, Add add) {
  const CageTables& cage = *block.cage;
  const auto* const point = reinterpret_cast<const Lanes*>(block.points);
  for (int f = 0; f < cage.faces; ++f) {
    Small left = near.rule[f] < near.rules;
    if (bytes_of(left) == 0) continue;
    const FaceTable<double>& face = cage.face[f];
    const double* const corner[3] = {cage.vertex + 3 * face.vertex[0], cage.vertex + 3 * face.vertex[1],
                                     cage.vertex + 3 * face.vertex[2]};
    double edges[2][3];
    for (int i = 0; i < 3; ++i) {
      edges[0][i] = corner[1][i] - corner[0][i];
      edges[1][i] = corner[2][i] - corner[0][i];
    }
    const Three<Lanes> x = from_point(cage, point, face.vertex[0]);
    while (const unsigned long long bytes = bytes_of(left)) {
      const int rule = static_cast<unsigned char>(near.rule[f][__builtin_ctzll(bytes) / 8]);
      const Small mine = left & (near.rule[f] == Small{} + static_cast<signed char>(rule));
      add(f, x, FarMoments<L, O>(cage.rules[rule], x, edges, 0.5 * face.area2, widened(mine)));
      left &= ~mine;
    }
  }
}

}  // namespace cageproof::closed_form::batch::CAGEPROOF_SIMD
