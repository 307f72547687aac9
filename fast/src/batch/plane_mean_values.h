// SPDX-License-Identifier: MIT
// Mean value coordinates of a polygon, a vector of points at a time: weights w_v of sums of t/|z|, t = tan(angle/2) of
// the two edges at a vertex, normalised ([T18] Eq 11 in the plane).
//
// The angle is Im L, so that its derivatives are those of an analytic function: L' = E/(z0 z1), L'' = L' (1/z0 + 1/z1);
// and grad t = (1 + t^2)/2 grad angle.
#pragma once

#include "leading.h"
#include "plane_base.h"

namespace cageproof::closed_form::batch::CAGEPROOF_SIMD {

/// The least square of a distance from a vertex: the weights' derivatives have powers to -3 and -5 of distances, which
/// stay in double's range.
template <int O>
inline constexpr double kLeastSquareOfWeights = O == 0   ? kLeastSquare
                                                : O == 1 ? 0x1p-600
                                                         : 0x1p-380;

/// 1/|z| of a vertex.
template <int O>
PlaneJet over_distance(const SeenEnd& end, Lanes distance) {
  PlaneJet over;
  over.value = 1 / distance;
  const Lanes cube = over.value / end.square;
  const Lanes z[2] = {end.z.re, end.z.im};
  if constexpr (O >= 1)
    for (int i = 0; i < 2; ++i) over.gradient[i] = cube * z[i];
  if constexpr (O >= 2) {
    const Lanes fifth = 3 * cube / end.square;
    for (int at = 0; at < 3; ++at) over.hessian[at] = fifth * z[kFirst[at]] * z[kSecond[at]];
    over.hessian[0] -= cube;
    over.hessian[2] -= cube;
  }
  return over;
}

/// t of an edge. \param half its value
template <int O>
PlaneJet tangent_of(const SideTable& side, const SeenEnd& a, const SeenEnd& b, Lanes half) {
  PlaneJet t;
  t.value = half;
  if constexpr (O >= 1) {
    const Complex first = times(side.e, a.over * b.over);
    const Lanes rise = 0.5 * (1 + half * half);
    for (int i = 0; i < 2; ++i) t.gradient[i] = along(first, i).im;
    if constexpr (O >= 2) {
      const Complex second = first * (a.over + b.over);
      for (int at = 0; at < 3; ++at) {
        const int i = kFirst[at], j = kSecond[at];
        t.hessian[at] = rise * (along(along(second, i), j).im + half * t.gradient[i] * t.gradient[j]);
      }
    }
    for (Lanes& d : t.gradient) d *= rise;
  }
  return t;
}

/// The weights' jets at each vertex, without those of base edges, become those of the coordinates.
template <int O>
void normalise_from_sides(PlaneBlock& block, const BaseSide& base) {
  auto* const columns = reinterpret_cast<Lanes*>(block.columns);
  const PlaneSums sums{columns, &block.layout};
  const auto at = [&](int v) {
    PlaneJet jet;
    jet.value = *sums.at(0, 0, v, 1);
    for (int i = 0; i < 2; ++i) jet.gradient[i] = sums.at(1, 0, v, 2)[i];
    if constexpr (O >= 2)
      for (int i = 0; i < 3; ++i) jet.hessian[i] = sums.at(2, 0, v, 3)[i];
    return jet;
  };
  PlaneJet others;
  for (int v = 0; v < block.cage->vertices; ++v) others = sum_of<O>(others, at(v));
  // Without a base edge there is no height to multiply with.
  PlaneJet height = base.height, share[2] = {base.share, scaled_jet<O>(base.share, -1)};
  height.value = select(base.seen, height.value, splat(1));
  share[1].value += 1;
  const PlaneJet whole = sum_of<O>(product_of<O>(height, others), base.total);
  const Lanes over = 1 / whole.value;
  block.left |= bits_of_lanes(~((over - over) == Lanes{}));
  for (int v = 0; v < block.cage->vertices; ++v) {
    PlaneJet rest = at(v), own, part;
    for (int k = 0; k < 2; ++k) {
      const Mask mine = base.seen & (base.vertex[k] == splat(v));
      if (!any(mine)) continue;
      take<O>(mine, share[k], own);
      take<O>(mine, scaled_jet<O>(base.rest, k == 0 ? 1 : -1), part);
      rest = sum_of<O>(rest, kept<O>(mine, scaled_jet<O>(product_of<O>(share[k], others), -1)));
    }
    part = sum_of<O>(part, product_of<O>(height, rest));
    *sums.at(0, 0, v, 1) = own.value + part.value * over;
    Lanes gradient[2];
    for (int i = 0; i < 2; ++i) {
      gradient[i] = (part.gradient[i] - part.value * over * whole.gradient[i]) * over;
      sums.at(1, 0, v, 2)[i] = own.gradient[i] + gradient[i];
    }
    if constexpr (O >= 2)
      for (int i = 0; i < 3; ++i) {
        const int a = kFirst[i], b = kSecond[i];
        sums.at(2, 0, v, 3)[i] = (part.hessian[i] - part.value * over * whole.hessian[i] -
                                  gradient[a] * whole.gradient[b] - gradient[b] * whole.gradient[a]) *
                                 over;
      }
  }
  complete(columns, block.layout, {1, 2, 3}, O, block.cage->vertices);
}

/// The weights' jets at each vertex become those of the coordinates. Points whose weights sum to nothing are left to
/// others.
template <int O>
void normalise_plane(PlaneBlock& block) {
  auto* const columns = reinterpret_cast<Lanes*>(block.columns);
  const PlaneSums sums{columns, &block.layout};
  const int vertices = block.cage->vertices;
  PlaneJet whole;
  for (int v = 0; v < vertices; ++v) {
    whole.value += *sums.at(0, 0, v, 1);
    if constexpr (O >= 1)
      for (int i = 0; i < 2; ++i) whole.gradient[i] += sums.at(1, 0, v, 2)[i];
    if constexpr (O >= 2)
      for (int i = 0; i < 3; ++i) whole.hessian[i] += sums.at(2, 0, v, 3)[i];
  }
  const Lanes over = 1 / whole.value;
  block.left |= bits_of_lanes(~((over - over) == Lanes{}));
  for (int v = 0; v < vertices; ++v) {
    Lanes& value = *sums.at(0, 0, v, 1);
    value *= over;
    if constexpr (O >= 1) {
      Lanes* const gradient = sums.at(1, 0, v, 2);
      for (int i = 0; i < 2; ++i) gradient[i] = (gradient[i] - value * whole.gradient[i]) * over;
      if constexpr (O >= 2) {
        Lanes* const hessian = sums.at(2, 0, v, 3);
        for (int at = 0; at < 3; ++at) {
          const int i = kFirst[at], j = kSecond[at];
          hessian[at] = (hessian[at] - value * whole.hessian[at] - gradient[i] * whole.gradient[j] -
                         gradient[j] * whole.gradient[i]) *
                        over;
        }
      }
    }
  }
  complete(columns, block.layout, {1, 2, 3}, O, vertices);
}

template <int O>
void sum_mean_values_of_plane(PlaneBlock& block) {
  const PolygonTables& cage = *block.cage;
  auto* const vertex = static_cast<SeenEnd*>(block.scratch);
  auto* const columns = reinterpret_cast<Lanes*>(block.columns);
  const PlaneSums sums{columns, &block.layout};
  const auto* const point = reinterpret_cast<const Lanes*>(block.points);
  for (int c = 0; c < block.layout.count; ++c) columns[c] = Lanes{};
  for (int v = 0; v < cage.vertices; ++v) {
    SeenEnd& seen = vertex[v];
    seen.z = {cage.vertex[2 * v] - point[0], cage.vertex[2 * v + 1] - point[1]};
    seen.square = squared(seen.z);
    seen.log = root(seen.square);  // the distance stands in for its logarithm here
    if constexpr (O >= 1) seen.over = inverse(seen.z);
    block.left |= bits_of_lanes(seen.square < splat(kLeastSquareOfWeights<O>));
  }
  BaseSide base;
  Lanes from = splat(-1), least = splat(1e300);
  if constexpr (O >= 1)
    for (int s = 0; s < cage.sides; ++s)
      from = select(is_base(cage.side[s], vertex[cage.side[s].from], vertex[cage.side[s].to], least), splat(s), from);
  for (int s = 0; s < cage.sides; ++s) {
    const SideTable& side = cage.side[s];
    const SeenEnd* const end[2] = {vertex + side.from, vertex + side.to};
    Mask mine{};
    if constexpr (O >= 1) {
      mine = from == splat(s);
      if (any(mine)) keep_side<O>(side, *end[0], *end[1], mine, base);
      const double close = kLeftAtEnds[O] * kLeftAtEnds[O] * side.square;
      block.left |= bits_of_lanes((end[0]->square < splat(close)) | (end[1]->square < splat(close)) |
                                  (mine & (least < splat(kLostOverSide * side.length))));
    }
    SeenSide seen;
    see_across(side, *end[0], *end[1], seen);
    decide_sides(block, side, seen);
    const Lanes product = end[0]->log * end[1]->log;
    const Mask acute = seen.along > Lanes{};
    const Lanes half =
        select(acute, seen.across, product - seen.along) / select(acute, product + seen.along, seen.across);
    const PlaneJet tangent = tangent_of<O>(side, *end[0], *end[1], half);
    const int number[2] = {side.from, side.to};
    for (int k = 0; k < 2; ++k) {
      PlaneJet weight = product_of<O>(tangent, over_distance<O>(*end[k], end[k]->log));
      if constexpr (O >= 1)
        if (any(mine)) weight = kept<O>(~mine, weight);
      *sums.at(0, 0, number[k], 1) += weight.value;
      if constexpr (O >= 1)
        for (int i = 0; i < 2; ++i) sums.at(1, 0, number[k], 2)[i] += weight.gradient[i];
      if constexpr (O >= 2)
        for (int i = 0; i < 3; ++i) sums.at(2, 0, number[k], 3)[i] += weight.hessian[i];
    }
  }
  if constexpr (O >= 1)
    if (any(base.seen)) return normalise_from_sides<O>(block, base);
  normalise_plane<O>(block);
}

}  // namespace cageproof::closed_form::batch::CAGEPROOF_SIMD
