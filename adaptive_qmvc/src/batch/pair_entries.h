// SPDX-License-Identifier: MIT
// Functions that the sources of each instruction set define.
#pragma once

#include "pair_sums.h"

namespace cageproof::adaptive_qmvc::batch::CAGEPROOF_SIMD {

inline void distances(const Chunk& chunk, const EdgeTable& edge, double* to) {
  for (int first = 0; first < chunk.stride; first += kLanes) {
    const Three from = points_from(chunk, first, edge.from);
    Lanes t = -dot(edge.along, from) * edge.over2;
    t = select(t < Lanes{}, Lanes{}, t);
    t = select(t > 1.0, splat(1), t);
    const Three nearest{from.x + t * edge.along[0], from.y + t * edge.along[1], from.z + t * edge.along[2]};
    const Lanes distance = root(dot(nearest, nearest));
    __builtin_memcpy(to + first, &distance, sizeof distance);
  }
}

inline void add(const Pairs& pairs) {
  if (pairs.along != nullptr) add_by_nodes(pairs);
  else add_elementary(pairs);
}

inline void normalise(const Chunk& chunk, int vertices, double* whole) {
  for (int first = 0; first < chunk.stride; first += kLanes) {
    Lanes all{};
    for (int v = 0; v < vertices; ++v) all += load(chunk.sums + v * static_cast<long>(chunk.stride) + first);
    __builtin_memcpy(whole + first, &all, sizeof all);
    for (int v = 0; v < vertices; ++v) {
      double* const column = chunk.sums + v * static_cast<long>(chunk.stride) + first;
      const Lanes quotient = load(column) / all;
      __builtin_memcpy(column, &quotient, sizeof quotient);
    }
  }
}

}  // namespace cageproof::adaptive_qmvc::batch::CAGEPROOF_SIMD
