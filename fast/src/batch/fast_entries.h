// SPDX-License-Identifier: MIT
// Functions that the sources of each instruction set define: sums in double, and the finishing of their columns.
#pragma once

#include "careful_entries.h"
#include "fast.h"
#include "mean_value_derivatives.h"
#include "mean_values.h"
#include "plane_sums.h"

namespace cageproof::closed_form::batch::CAGEPROOF_SIMD {

inline Measures first_limits() {
  const Lanes no_limit = splat(__builtin_inf());
  return {splat(kThin), no_limit, no_limit};
}

inline void sum(Block& block) {
  block.left = 0;
  if (block.layers == Layers::MeanValue) {
    if (block.order == 0) return sum_mean_values(block);
    return block.order == 1 ? sum_mean_value_derivatives<1>(block) : sum_mean_value_derivatives<2>(block);
  }
  auto& measured = *static_cast<MeasuredBlock*>(block.measured);
  measured.limits = first_limits();
  measured.rules = Small{} + static_cast<signed char>(kFirstRules);
  measured.lowered = Mask{};
  with_layers(block.layers, block.order, [&]<Layers L, int O> { sum_faces<L, O>(block, measured); });
}

inline bool sum_again(Block& block) {
  auto& measured = *static_cast<MeasuredBlock*>(block.measured);
  bool again = false;
  with_layers(block.layers, block.order, [&]<Layers L, int O> {
    const Measures before = measured.limits, first = first_limits();
    const Mask found = lower_limits<L, O>(block, measured) & ~measured.lowered;
    again = any(found);
    if (!again) return;
    // First with more rules, then with lower limits, for each point by itself.
    const Mask ruled = found & measured.between;
    take_all_rules(measured, ruled);
    measured.lowered |= found & ~ruled;
    const auto choose = [&](Lanes& limit, Lanes had, Lanes fresh) {
      limit = select(ruled, fresh, select(found, limit, had));
    };
    choose(measured.limits.thin, before.thin, first.thin);
    choose(measured.limits.of_layer, before.of_layer, first.of_layer);
    choose(measured.limits.of_distance, before.of_distance, first.of_distance);
    sum_faces<L, O>(block, measured);
  });
  return again;
}
inline long measured_bytes() {
  return sizeof(MeasuredBlock) > sizeof(BaseFace) ? sizeof(MeasuredBlock) : sizeof(BaseFace);
}

inline long scratch_bytes(int vertices, int edges, int faces, int columns) {
  // The most that any layers and order take.
  constexpr long of_edge = sizeof(EdgeTerms<Lanes, 2>);
  static_assert(of_edge >= static_cast<long>(sizeof(SeenEdge)));
  static_assert(of_edge >= static_cast<long>(sizeof(MeanValueEdge)));
  const long fast = vertices * static_cast<long>(sizeof(SeenVertex)) + edges * of_edge +
                    faces * static_cast<long>(sizeof(Lanes)) + near_bytes(vertices, edges, faces);
  const long careful = careful_bytes(columns);
  return fast > careful ? fast : careful;
}

/// Derivatives of one order, of which the kept columns are as many as a symmetric matrix has different entries.
template <int Width>
struct Order {
  static constexpr int kept = Width;
  /// The place of a derivative among those kept.
  static constexpr int place(int i) { return i; }
};
template <>
struct Order<4> {
  static constexpr int kept = 3;
  static constexpr int place(int i) { return i == 0 ? 0 : (i + 1) / 2; }
};
template <>
struct Order<9> {
  static constexpr int kept = 6, places[9] = {0, 1, 2, 1, 3, 4, 2, 4, 5};
  static constexpr int place(int i) { return places[i]; }
};

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

/// Transposes columns to rows, some at a time, so that each piece stays in the nearest cache.
template <int Width, bool Streaming>
void store_rows(const Rows& rows, int points) {
  constexpr int tile = 48, kept = Order<Width>::kept;
  static_assert(tile % kept == 0);
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
      double* to = rows.to + rows.row[p] * rows.stride + first / kept * Width;
      for (int c = 0; c < here; c += kept, to += Width)
        for (int i = 0; i < Width; ++i) put<Streaming>(to + i, scaled[c + Order<Width>::place(i)][p]);
    }
  }
}

/// Calls f.template operator()<Width>() for a number of derivatives.
template <class F>
void with_width(int width, F f) {
  switch (width) {
    case 1: return f.template operator()<1>();
    case 2: return f.template operator()<2>();
    case 3: return f.template operator()<3>();
    case 4: return f.template operator()<4>();
    default: return f.template operator()<9>();
  }
}

inline void store(const Rows& rows, int points) {
  with_width(rows.width, [&]<int Width> {
    if (rows.streaming) store_rows<Width, true>(rows, points);
    else store_rows<Width, false>(rows, points);
  });
#if defined(__SSE2__)
  // From here on, other threads see the rows that were written past the caches.
  if (rows.streaming) __builtin_ia32_sfence();
#endif
}

/// `Sets` sets of one row's products, so that columns are read once for them.
template <int Width, int Sets>
void multiply_sets(const Products& product, int points, int row, int first) {
  constexpr int kept = Order<Width>::kept;
  const auto* const from = reinterpret_cast<const Lanes*>(product.from);
  Lanes sum[Sets][kept] = {};
  for (int c = 0; c < product.coordinates; ++c)
    for (int column = 0; column < product.columns; ++column) {
      const double* const x = product.data + (c * product.columns + column) * product.sets + first;
      const Lanes* const entry = from + ((c * product.rows + row) * product.columns + column) * kept;
      for (int i = 0; i < kept; ++i)
        for (int set = 0; set < Sets; ++set) sum[set][i] += x[set] * entry[i];
    }
  for (int set = 0; set < Sets; ++set)
    for (int p = 0; p < points; ++p) {
      double* const to = product.to + product.point[p] * product.stride + (row * product.sets + first + set) * Width;
      for (int i = 0; i < Width; ++i) to[i] += sum[set][Order<Width>::place(i)][p] * product.factor;
    }
}

inline void multiply(const Products& product, int points) {
  with_width(product.width, [&]<int Width> {
    for (int row = 0; row < product.rows; ++row) {
      int set = 0;
      for (; set + 3 <= product.sets; set += 3) multiply_sets<Width, 3>(product, points, row, set);
      for (; set < product.sets; ++set) multiply_sets<Width, 1>(product, points, row, set);
    }
  });
}

}  // namespace cageproof::closed_form::batch::CAGEPROOF_SIMD
