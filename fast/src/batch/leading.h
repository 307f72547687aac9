// SPDX-License-Identifier: MIT
// The derivatives of the coordinate that is more than half, next to its vertex, where its own quotient rule cancels.
#pragma once

#include "cageproof/closed_form/batch/lanes.h"

#include "kernels.h"

namespace cageproof::closed_form::batch::CAGEPROOF_SIMD {

/// For each point, the vertex with the largest coordinate above 1/2; -1 where there is none.
inline Lanes leading(const Lanes* values, int vertices) {
  Lanes most = splat(0.5), lead = splat(-1);
  for (int v = 0; v < vertices; ++v) {
    const Mask more = values[v] > most;
    most = select(more, values[v], most);
    lead = select(more, splat(v), lead);
  }
  return lead;
}

/// Makes a leading coordinate's derivatives minus the sum of all others'. \param kept numbers per vertex, by order
inline void complete(Lanes* columns, const Columns& layout, const int (&kept)[3], int order, int vertices) {
  if (order == 0) return;
  const Lanes lead = leading(columns + layout.first[0][0], vertices);
  if (!any(lead >= Lanes{})) return;
  for (int o = 1; o <= order; ++o)
    for (int i = 0; i < kept[o]; ++i) {
      Lanes* const column = columns + layout.first[o][0] + i;
      Lanes others{};
      for (int v = 0; v < vertices; ++v) others += select(lead == splat(v), Lanes{}, column[kept[o] * v]);
      for (int v = 0; v < vertices; ++v) {
        Lanes& own = column[kept[o] * v];
        own = select(lead == splat(v), -others, own);
      }
    }
}

}  // namespace cageproof::closed_form::batch::CAGEPROOF_SIMD
