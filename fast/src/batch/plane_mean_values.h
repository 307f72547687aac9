// SPDX-License-Identifier: MIT
// Mean value coordinates of a polygon, a vector of points at a time: weights w_v of sums of t/|z|, t = tan(angle/2) of
// the two edges at a vertex, normalised ([T18] Eq 11 in the plane).
//
// The angle is Im L, so that its derivatives are those of an analytic function: L' = E/(z0 z1), L'' = L' (1/z0 + 1/z1);
// and grad t = (1 + t^2)/2 grad angle.
#pragma once

#include "leading.h"
#include "plane_kelvin.h"

namespace cageproof::closed_form::batch::CAGEPROOF_SIMD {

/// The least square of a distance from a vertex: the weights' derivatives have powers to -3 and -5 of distances, which
/// stay in double's range.
template <int O>
inline constexpr double kLeastSquareOfWeights = O == 0   ? kLeastSquare
                                                : O == 1 ? 0x1p-600
                                                         : 0x1p-380;

/// A function of the points with derivatives xx, xy, yy.
struct PlaneJet {
  Lanes value{}, gradient[2] = {}, hessian[3] = {};
};
template <int O>
PlaneJet product_of(const PlaneJet& a, const PlaneJet& b) {
  PlaneJet c;
  c.value = a.value * b.value;
  if constexpr (O >= 1)
    for (int i = 0; i < 2; ++i) c.gradient[i] = a.gradient[i] * b.value + a.value * b.gradient[i];
  if constexpr (O >= 2)
    for (int at = 0; at < 3; ++at) {
      const int i = kFirst[at], j = kSecond[at];
      c.hessian[at] = a.hessian[at] * b.value + a.gradient[i] * b.gradient[j] + a.gradient[j] * b.gradient[i] +
                      a.value * b.hessian[at];
    }
  return c;
}

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
  for (int s = 0; s < cage.sides; ++s) {
    const SideTable& side = cage.side[s];
    const SeenEnd* const end[2] = {vertex + side.from, vertex + side.to};
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
      const PlaneJet weight = product_of<O>(tangent, over_distance<O>(*end[k], end[k]->log));
      *sums.at(0, 0, number[k], 1) += weight.value;
      if constexpr (O >= 1)
        for (int i = 0; i < 2; ++i) sums.at(1, 0, number[k], 2)[i] += weight.gradient[i];
      if constexpr (O >= 2)
        for (int i = 0; i < 3; ++i) sums.at(2, 0, number[k], 3)[i] += weight.hessian[i];
    }
  }
  normalise_plane<O>(block);
}

}  // namespace cageproof::closed_form::batch::CAGEPROOF_SIMD
