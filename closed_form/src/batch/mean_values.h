// SPDX-License-Identifier: MIT
// Mean value coordinates of a triangle cage, a vector of points at a time: values ([T18] Eq 11, 13).
//
// With d the height, K2 the integral of r^-2 over an edge (its angle over the distance of its line), F = sum h K2 and
// G_k = sum (nu g_k) K2, a face's weights are w_k = (d G_k - Gamma_k F/d)/2. Near the face's plane F/d cancels, and is
// taken as (2 pi within the face, or 0)/d - d sum rest, rest = h int 1/(r^2 rho^2), rho the distance from the point's
// projection: what the height takes off each angle in the plane.
#pragma once

#include "fast.h"

namespace cageproof::closed_form::batch::CAGEPROOF_SIMD {

/// One edge seen from the points.
struct SeenEdge {
  Lanes angle_over;  ///< K2
  Lanes square;      ///< squared distance of the line
  Lanes distance;    ///< its root
  Lanes ends;        ///< s0 s1
};

/// Heights below this, over the distance of a corner, take the form next to the plane.
inline constexpr double kNextToPlane = 0x1p-9;
/// Distances from an edge's line, or from a corner, below this times the edge are left to others; likewise heights
/// within a face.
inline constexpr double kLeftAlone = 0x1p-30;
/// Faces whose hat functions grow by more than this up to the point are as well.
inline constexpr double kSteepest = 256;

inline SeenEdge seen_edge(const EdgeTable<double>& e, const Three<Lanes>& p0, const Three<Lanes>& p1) {
  const Three<Lanes> normal = cross(p0, p1);
  const Lanes across = root(dot(normal, normal));
  const Lanes s = dot(e.u, p0);
  SeenEdge seen;
  seen.distance = across * e.over;
  seen.square = seen.distance * seen.distance;
  seen.ends = s * (s + e.length);
  seen.angle_over = angle_of(across, dot(p0, p1)) / seen.distance;
  return seen;
}

/// h int 1/(r^2 rho^2) over an edge. \param d2 the squared height
inline Lanes in_plane_rest(const EdgeTable<double>& table, const SeenEdge& e, Lanes h, Lanes d2) {
  const Lanes reach = magnitude(h);
  const Lanes flat = reach * reach + e.ends;
  const Lanes angle = angle_of(reach * table.length, flat);
  const Lanes over = 1 / (e.distance + reach);
  // The angle in the plane less the one in space, as one angle: that of (y, x), where y has the squared height.
  const Lanes y = over * (reach * e.distance - e.ends) * table.length;
  const Lanes x = flat * (e.square + e.ends) + reach * e.distance * (table.length * table.length);
  const Lanes t = y / x, t2 = t * d2 * (t * d2);
  const Lanes turn =
      select((x > Lanes{}) & (t2 < splat(1e-8)), t * (1 - t2 * (1 / 3. - t2 * 0.2)), angle_of(y * d2, x) / d2);
  const Lanes rest = (angle * over + reach * turn) / e.distance;
  return select(h < Lanes{}, -rest, rest);
}

inline void sum_mean_values(Block& block) {
  const CageTables& cage = *block.cage;
  auto* const vertex = static_cast<SeenVertex*>(block.scratch);
  auto* const edge = reinterpret_cast<SeenEdge*>(vertex + cage.vertices);
  auto* const columns = reinterpret_cast<Lanes*>(block.columns);
  const auto* const point = reinterpret_cast<const Lanes*>(block.points);
  Mask left = mask_of(block.whole);
  for (int v = 0; v < cage.vertices; ++v) {
    SeenVertex& seen = vertex[v];
    columns[v] = Lanes{};
    for (int i = 0; i < 3; ++i) seen.x[i] = cage.vertex[3 * v + i] - point[i];
    seen.r = root(dot(seen.x, seen.x));
    left |= less(seen.r, splat(kLeftAlone * cage.reach[v]));
  }
  for (int e = 0; e < cage.edges; ++e) {
    const EdgeTable<double>& table = cage.edge[e];
    edge[e] = seen_edge(table, vertex[table.from].x, vertex[table.to].x);
    left |= less(edge[e].distance, splat(kLeftAlone * table.length));
  }
  Lanes whole{};
  for (int f = 0; f < cage.faces; ++f) {
    const FaceTable<double>& face = cage.face[f];
    const SeenVertex* const corner[3] = {vertex + face.vertex[0], vertex + face.vertex[1], vertex + face.vertex[2]};
    const SeenEdge* const side[3] = {edge + face.edge[0], edge + face.edge[1], edge + face.edge[2]};
    const Lanes d = -dot(face.n, corner[0]->x), height = magnitude(d);
    Lanes h[3], flux{};
    for (int e = 0; e < 3; ++e) {
      h[e] = dot(face.nu[e], corner[e]->x);
      flux += h[e] * side[e]->angle_over;
    }
    left |= corner[0]->r * face.steep > kSteepest;
    Lanes over = flux / d;
    const Mask flat = height < kNextToPlane * corner[0]->r;
    if (any(flat)) {
      Lanes rest{};
      for (int e = 0; e < 3; ++e) rest += in_plane_rest(cage.edge[face.edge[e]], *side[e], h[e], d * d);
      const Mask within = (h[0] > Lanes{}) & (h[1] > Lanes{}) & (h[2] > Lanes{});
      left |= within & (height < kLeftAlone * corner[0]->r);
      const Lanes turn = select(within, 6.2831853071795862 / d, Lanes{});
      over = select(flat, turn - d * rest, over);
    }
    const Lanes hat[2] = {h[1] * face.hat[0], h[2] * face.hat[1]};
    Lanes last = -over;  // the three weights' sum, twice
    for (int k = 0; k < 2; ++k) {
      const Lanes across = side[0]->angle_over * face.across[k][0] + side[1]->angle_over * face.across[k][1] +
                           side[2]->angle_over * face.across[k][2];
      const Lanes weight = d * across - hat[k] * over;
      columns[face.vertex[k]] += weight;
      last -= weight;
    }
    columns[face.vertex[2]] += last;
    whole -= over;
  }
  for (int v = 0; v < cage.vertices; ++v) columns[v] /= whole;
  // What is no number has met a distance of zero on the way.
  left |= ~((whole - whole) == Lanes{});
  block.marked = 0;
  block.left = bits_of(left);
}

}  // namespace cageproof::closed_form::batch::CAGEPROOF_SIMD
