// SPDX-License-Identifier: MIT
// Far faces' weights of mean value coordinates and their derivatives, for one instruction set: with p from the point to
// the face, e = n p, they are -M = 2 e int hat r^-4; grad p = -Id, grad e = -n, grad r^-s = s p r^-(s+2).
#pragma once

#include "far_sums.h"

namespace cageproof::closed_form::batch::CAGEPROOF_SIMD {

/// Adds the faces that are far. \param heights of the points over all faces \return the sum of the weights M
template <int O>
Lanes add_far_mean_values(const Block& block, const NearFaces& near, const Lanes* heights) {
  const CageTables& cage = *block.cage;
  auto* const columns = reinterpret_cast<Lanes*>(block.columns);
  Lanes total{};
  using Moments = FarMoments<Layers::MeanValue, O>;
  for_far_faces<Layers::MeanValue, O>(block, near, [&](int f, const Three<Lanes>&, const Moments& m) {
    const FaceTable<double>& face = cage.face[f];
    const double* const n = face.n;
    const Lanes e = -heights[f], twice = e + e;
    const auto at = [&](int order, int k, int size) {
      return columns + block.layout.first[order][0] + face.vertex[k] * size;
    };
    for (int k = 0; k < 3; ++k) {
      const Lanes weight = twice * m.hats04.of[k][0];
      *at(0, k, 1) += weight;
      total -= weight;
      if constexpr (O >= 1) {
        Lanes* const gradient = at(1, k, 3);
        for (int i = 0; i < 3; ++i) gradient[i] += 4 * twice * m.hats16.of[k][i] - (2 * n[i]) * m.hats04.of[k][0];
      }
      if constexpr (O >= 2) {
        Lanes* const hessian = at(2, k, 6);
        for_each_entry<2>([&](int i, int j, int entry) {
          Lanes x = 24 * twice * m.hats28.of[k][entry] - 8 * (n[i] * m.hats16.of[k][j] + n[j] * m.hats16.of[k][i]);
          if (i == j) x -= 4 * twice * m.hats06.of[k][0];
          hessian[entry] += x;
        });
      }
    }
  });
  return total;
}

}  // namespace cageproof::closed_form::batch::CAGEPROOF_SIMD
