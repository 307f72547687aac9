// SPDX-License-Identifier: MIT
// What sources of each instruction set define: sums in double, and what becomes of their columns.
#pragma once

#include "careful_entries.h"
#include "fast.h"

namespace cageproof::closed_form::batch::CAGEPROOF_SIMD {

inline void sum(Block& block) {
  if (block.layers == Layers::Kelvin) return sum_faces<Layers::Kelvin, 0>(block);
  const bool biharmonic = block.layers == Layers::Biharmonic;
  switch (block.order) {
    case 0: return biharmonic ? sum_faces<Layers::Biharmonic, 0>(block) : sum_faces<Layers::Harmonic, 0>(block);
    case 1: return biharmonic ? sum_faces<Layers::Biharmonic, 1>(block) : sum_faces<Layers::Harmonic, 1>(block);
    default: return biharmonic ? sum_faces<Layers::Biharmonic, 2>(block) : sum_faces<Layers::Harmonic, 2>(block);
  }
}

inline long scratch_bytes(int vertices, int edges, int columns) {
  const long fast =
      vertices * static_cast<long>(sizeof(SeenVertex)) + edges * static_cast<long>(sizeof(EdgeTerms<Lanes>));
  const long careful = careful_bytes(columns);
  return fast > careful ? fast : careful;
}

/// Places of a symmetric matrix's nine entries among its six.
inline constexpr int kSymmetric[9] = {0, 1, 2, 1, 3, 4, 2, 4, 5};

inline void store(const Rows& rows, int points) {
  const int kept = rows.width == 9 ? 6 : rows.width;
  const int groups = rows.coordinates * rows.entries;
  for (int p = 0; p < points; ++p) {
    double* to = rows.to + p * rows.stride;
    const double* from = rows.from + p;
    if (rows.width < 9) {
      const int count = groups * kept;
      for (int c = 0; c < count; ++c) to[c] = from[c * kLanes] * rows.factor;
      continue;
    }
    for (int g = 0; g < groups; ++g, to += 9, from += 6 * kLanes)
      for (int i = 0; i < 9; ++i) to[i] = from[kSymmetric[i] * kLanes] * rows.factor;
  }
}

inline void multiply(const Products& product, int points) {
  const int kept = product.width == 9 ? 6 : product.width;
  const auto* const from = reinterpret_cast<const Lanes*>(product.from);
  for (int row = 0; row < product.rows; ++row)
    for (int set = 0; set < product.sets; ++set) {
      Lanes sum[6] = {};
      for (int c = 0; c < product.coordinates; ++c)
        for (int column = 0; column < product.columns; ++column) {
          const double x = product.data[(c * product.columns + column) * product.sets + set];
          const Lanes* const entry = from + ((c * product.rows + row) * product.columns + column) * kept;
          for (int i = 0; i < kept; ++i) sum[i] += x * entry[i];
        }
      for (int p = 0; p < points; ++p) {
        double* const to = product.to + p * product.stride + (row * product.sets + set) * product.width;
        for (int i = 0; i < product.width; ++i)
          to[i] += sum[product.width == 9 ? kSymmetric[i] : i][p] * product.factor;
      }
    }
}

}  // namespace cageproof::closed_form::batch::CAGEPROOF_SIMD
