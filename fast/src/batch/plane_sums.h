// SPDX-License-Identifier: MIT
// Sums over all edges of a polygon, a vector of points at a time, for one instruction set.
#pragma once

#include "plane_kelvin.h"
#include "plane_mean_values.h"

namespace cageproof::closed_form::batch::CAGEPROOF_SIMD {

inline void see_vertices(PlaneBlock& block, SeenEnd* vertex) {
  const PolygonTables& cage = *block.cage;
  const auto* const point = reinterpret_cast<const Lanes*>(block.points);
  for (int v = 0; v < cage.vertices; ++v) {
    SeenEnd& seen = vertex[v];
    seen.z = {cage.vertex[2 * v] - point[0], cage.vertex[2 * v + 1] - point[1]};
    seen.square = squared(seen.z);
    seen.over = inverse(seen.z);
    seen.log = 0.5 * log_of_quotient(seen.square, splat(1), splat(1), Lanes{}, Mask{}) + block.unit_log;
    seen.apart = Mask{} == Mask{};
    block.left |= bits_of_lanes(seen.square < splat(kLeastSquare));
  }
  for (int s = 0; s < cage.sides; ++s) {
    const SideTable& side = cage.side[s];
    const Mask afar = is_afar(side, middle_of(vertex[side.from], vertex[side.to]));
    vertex[side.from].apart &= afar;
    vertex[side.to].apart &= afar;
  }
}

template <Layers L, int O>
void sum_sides(PlaneBlock& block) {
  const PolygonTables& cage = *block.cage;
  auto* const vertex = static_cast<SeenEnd*>(block.scratch);
  auto* const columns = reinterpret_cast<Lanes*>(block.columns);
  for (int c = 0; c < block.layout.count; ++c) columns[c] = Lanes{};
  const PlaneSums sums{columns, &block.layout};
  see_vertices(block, vertex);
  for (int s = 0; s < cage.sides; ++s) {
    const SideTable& side = cage.side[s];
    const SeenEnd &a = vertex[side.from], &b = vertex[side.to];
    SeenSide seen;
    seen.middle = middle_of(a, b);
    see_across(side, a, b, seen);
    const Mask afar = is_afar(side, seen.middle);
    const bool any_afar = any(afar), any_nearby = any(~afar);
    if (any_nearby) {
      decide_sides(block, side, seen);
      SeenSide nearby = seen;
      see_from_nearby(side, a, b, angle_of(seen.across, seen.along), nearby);
      if (any_afar) {
        see_from_afar(side, seen);
        seen = select(afar, seen, nearby);
      } else {
        seen = nearby;
      }
    } else {
      see_from_afar(side, seen);
    }
    const SeenEdgeOfPlane edge{side, a, b, seen};
    const Lanes mean_log = 0.5 * (a.log + b.log) + seen.bend.re;
    const Complex over_middle = any_afar ? inverse(seen.middle) : Complex{};
    if constexpr (L == Layers::Kelvin) {
      add_kelvin<O>(edge, afar, over_middle, mean_log, block.beta, sums, s);
    } else {
      add_harmonic<O>(edge, afar, over_middle, mean_log, sums, s);
      if constexpr (L == Layers::Biharmonic) add_biharmonic<O>(edge, afar, over_middle, mean_log, sums, s);
    }
  }
}

inline void sum_plane(PlaneBlock& block) {
  block.left = 0;
  if (block.layers == Layers::MeanValue) {
    if (block.order == 0) return sum_mean_values_of_plane<0>(block);
    return block.order == 1 ? sum_mean_values_of_plane<1>(block) : sum_mean_values_of_plane<2>(block);
  }
  with_layers(block.layers, block.order, [&]<Layers L, int O> { sum_sides<L, O>(block); });
}

inline long plane_scratch_bytes(int vertices) { return vertices * static_cast<long>(sizeof(SeenEnd)); }

}  // namespace cageproof::closed_form::batch::CAGEPROOF_SIMD
