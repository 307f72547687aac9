// SPDX-License-Identifier: MIT
// What sources of each instruction set define: sums in double, and what becomes of their columns.
#pragma once

#include "careful_entries.h"
#include "fast.h"
#include "mean_values.h"

namespace cageproof::closed_form::batch::CAGEPROOF_SIMD {

inline void sum(Block& block) {
  block.left = 0;
  if (block.layers == Layers::MeanValue) return sum_mean_values(block);
  with_layers(block.layers, block.order, [&]<Layers L, int O> { sum_faces<L, O>(block); });
}

inline long scratch_bytes(int vertices, int edges, int columns) {
  constexpr long of_edge = sizeof(EdgeTerms<Lanes>) > sizeof(SeenEdge) ? sizeof(EdgeTerms<Lanes>) : sizeof(SeenEdge);
  const long fast = vertices * static_cast<long>(sizeof(SeenVertex)) + edges * of_edge;
  const long careful = careful_bytes(columns);
  return fast > careful ? fast : careful;
}

/// Places of a symmetric matrix's nine entries among its six.
inline constexpr int kSymmetric[9] = {0, 1, 2, 1, 3, 4, 2, 4, 5};

/// Stores one number; where rows are more than caches hold, past these.
template <bool Streaming>
void put(double* to, double x) {
#if defined(__SSE2__)
  if constexpr (Streaming) {
    long long bits;
    __builtin_memcpy(&bits, &x, sizeof bits);
    __builtin_ia32_movnti64(reinterpret_cast<long long*>(to), bits);
    return;
  }
#endif
  *to = x;
}

/// Columns to rows, some at a time, so that what is turned stays in the nearest cache.
template <bool Streaming>
void store_rows(const Rows& rows, int points) {
  constexpr int tile = 48;
  const int kept = rows.width == 9 ? 6 : rows.width;
  const int count = rows.coordinates * rows.entries * kept;
  const auto* const from = reinterpret_cast<const Lanes*>(rows.from);
  for (int first = 0; first < count; first += tile) {
    const int here = count - first < tile ? count - first : tile;
    double scaled[tile][kLanes];
    for (int c = 0; c < here; ++c) {
      const Lanes x = from[first + c] * rows.factor;
      __builtin_memcpy(scaled[c], &x, sizeof x);
    }
    for (int p = 0; p < points; ++p) {
      double* to = rows.to + p * rows.stride + (kept == 6 ? first / 2 * 3 : first);
      if (kept == 6) {
        for (int c = 0; c < here; c += 6, to += 9)
          for (int i = 0; i < 9; ++i) put<Streaming>(to + i, scaled[c + kSymmetric[i]][p]);
      } else {
        for (int c = 0; c < here; ++c) put<Streaming>(to + c, scaled[c][p]);
      }
    }
  }
}

inline void store(const Rows& rows, int points) {
  if (!rows.streaming) return store_rows<false>(rows, points);
  store_rows<true>(rows, points);
#if defined(__SSE2__)
  // Other threads see what went past the caches from here on.
  __builtin_ia32_sfence();
#endif
}

/// `Sets` sets of one row's products, so that columns are read once for them.
template <int Kept, int Sets>
void multiply_sets(const Products& product, int points, int row, int first) {
  const auto* const from = reinterpret_cast<const Lanes*>(product.from);
  Lanes sum[Sets][Kept] = {};
  for (int c = 0; c < product.coordinates; ++c)
    for (int column = 0; column < product.columns; ++column) {
      const double* const x = product.data + (c * product.columns + column) * product.sets + first;
      const Lanes* const entry = from + ((c * product.rows + row) * product.columns + column) * Kept;
      for (int i = 0; i < Kept; ++i)
        for (int set = 0; set < Sets; ++set) sum[set][i] += x[set] * entry[i];
    }
  for (int set = 0; set < Sets; ++set)
    for (int p = 0; p < points; ++p) {
      double* const to = product.to + p * product.stride + (row * product.sets + first + set) * product.width;
      for (int i = 0; i < product.width; ++i) to[i] += sum[set][Kept == 6 ? kSymmetric[i] : i][p] * product.factor;
    }
}

template <int Kept>
void multiply_kept(const Products& product, int points) {
  for (int row = 0; row < product.rows; ++row) {
    int set = 0;
    for (; set + 3 <= product.sets; set += 3) multiply_sets<Kept, 3>(product, points, row, set);
    for (; set < product.sets; ++set) multiply_sets<Kept, 1>(product, points, row, set);
  }
}

inline void multiply(const Products& product, int points) {
  switch (product.width) {
    case 1: return multiply_kept<1>(product, points);
    case 3: return multiply_kept<3>(product, points);
    default: return multiply_kept<6>(product, points);
  }
}

}  // namespace cageproof::closed_form::batch::CAGEPROOF_SIMD
