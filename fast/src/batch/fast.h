// SPDX-License-Identifier: MIT
// Sums over all faces in double, a vector of points at a time, for one instruction set.
#pragma once

#include "cageproof/closed_form/batch/lanes.h"

#include "cancelling.h"
#include "face_terms.h"
#include "far_border.h"
#include "far_faces.h"
#include "far_sums.h"
#include "seen_vertex.h"

namespace cageproof::closed_form::batch::CAGEPROOF_SIMD {

/// Where the sides of the arc tangent that omega is are this small against the product of the distances, the point is
/// so near to an edge of the face that a rounding of its position turns the face's angle too much.
inline constexpr double kNextToEdge = 0x1p-7;
/// On which side of the face a point lies is left to more digits where the height is this small against the face.
inline constexpr double kNextToFace = 0x1p-36;

/// The edges' integrals of a thin face are divided by its height, which leaves that much of their rounding. Beyond this
/// times int r over its edges, or their lengths times the mean distance, the face needs more digits.
inline constexpr double kThin = 32;
/// Roundings of many thin faces add up. Where the root of the sum of these numbers' squares is beyond the first, as
/// next to a vertex of many long triangles, faces beyond the second need more digits as well. What biharmonic layers
/// are summed from is divided by heights twice.
template <Layers L>
inline constexpr double kManyThin = L == Layers::Biharmonic ? 100 : 160;
inline constexpr double kThinOfMany = 4;

/// The number of rules in use before roundings are known: those that are quicker than closed forms, and for Kelvin's
/// derivatives, which edge_tails.h does not reduce, those that keep their digits.
template <Layers L, int O>
inline constexpr int kRulesFirst = L == Layers::Kelvin&& O >= 1 ? 5 : 2;

/// The share of its rounding that a face with short edges keeps. edge_tails.h subtracts the common part of its edges'
/// integrals, so that their rounding shrinks by the longest edge over the distance, times this number. Roundings of
/// such faces are as many and as random as the faces. At least a third of their limit is the slope of the coordinates,
/// which is at least twice these over the distance.
inline constexpr double kOfShort = 0.15;
/// That share for derivatives of Kelvin's layers, at every distance.
inline constexpr double kOfShortKelvin = 0.015;

inline unsigned bits_of(Mask m) {
  unsigned bits = 0;
  for (int i = 0; i < kLanes; ++i) bits |= (m[i] != 0 ? 1u : 0u) << i;
  return bits;
}
inline Mask mask_of(unsigned bits) {
  Mask m;
  for (int i = 0; i < kLanes; ++i) m[i] = (bits >> i & 1u) != 0 ? -1 : 0;
  return m;
}

/// Faces ahead of the one that is summed whose tables are fetched, in cages of more faces than caches hold.
inline constexpr int kAhead = 3, kCachedFaces = 1000;
/// Coordinates of a face's single layer.
template <Layers L>
inline constexpr int kOfFace = L == Layers::Kelvin ? 9 : 1;
inline void prefetch(const FaceTable<double>& face) {
  const auto* const bytes = reinterpret_cast<const char*>(&face);
  for (unsigned long at = 0; at < sizeof face; at += 64) __builtin_prefetch(bytes + at);
}

/// The vertices and edges of a tile's near faces, as points see them.
template <Layers L, int O>
[[gnu::noinline]] void see_tile(const Block& block, const NearFaces& near, int tile, SeenVertex* vertex,
                                EdgeTerms<Lanes, Takes<L, O>::further>* edge) {
  const CageTables& cage = *block.cage;
  const Tiles& tiles = cage.tiles;
  const auto* const point = reinterpret_cast<const Lanes*>(block.points);
  const Mask whole = mask_of(block.whole);
  for (int slot = 0, i = tiles.first_vertex[tile]; i < tiles.first_vertex[tile + 1]; ++i, ++slot) {
    const int v = tiles.vertex[i];
    if (near.vertex[v] == 0) continue;
    SeenVertex& seen = vertex[slot];
    for (int k = 0; k < 3; ++k) seen.x[k] = cage.vertex[3 * v + k] - point[k];
    seen.r = root(dot(seen.x, seen.x));
    seen.near = less(seen.r, splat(cage.reach[v])) | whole;
  }
  for (int slot = 0, i = tiles.first_edge[tile]; i < tiles.first_edge[tile + 1]; ++i, ++slot) {
    const TileEdge& its = tiles.edge[i];
    if (near.edge[its.edge] == 0) continue;
    const SeenVertex &a = vertex[its.from], &b = vertex[its.to];
    edge[slot] = edge_terms<L, O, Lanes, double>(cage.edge[its.edge], a.x, b.x, a.r, b.r);
  }
}

/// Sums over the faces that are near, and lists those that need more digits, as the limits say.
template <Layers L, int O>
[[gnu::noinline]] void sum_faces_within(Block& block, const NearFaces& near, MeasuredBlock& measured) {
  using Edge = EdgeTerms<Lanes, Takes<L, O>::further>;
  const CageTables& cage = *block.cage;
  auto* const columns = reinterpret_cast<Lanes*>(block.columns);
  for (int c = 0; c < block.layout.count; ++c) columns[c] = Lanes{};
  const Sums<Lanes> sums{columns, &block.layout};
  const Lanes beta = splat(block.beta.high);
  const Measures limits = measured.limits;
  Measures squares;
  measured.thin_below = {};
  block.marked = 0;
  auto* const vertex = static_cast<SeenVertex*>(block.scratch);
  auto* const edge = reinterpret_cast<Edge*>(vertex + cage.vertices);
  for (int tile = 0; tile < cage.tiles.count; ++tile) {
    bool seen = false;
    for (int place = cage.tiles.first_face[tile]; place < cage.tiles.first_face[tile + 1]; ++place) {
      const int f = cage.tiles.face[place];
      const Small is_near = near.is_near(f);
      if (bytes_of(is_near) == 0) continue;
      if (!seen) see_tile<L, O>(block, near, tile, vertex, edge);
      seen = true;
      if (cage.faces > kCachedFaces && place + kAhead < cage.faces) {
        const int next = cage.tiles.face[place + kAhead];
        prefetch(cage.face[next]);
        __builtin_prefetch(sums.at(0, 1, next, kOfFace<L>), 1);
      }
      const FaceTable<double>& face = cage.face[f];
      const int(&slot)[6] = cage.tiles.slot[f];
      const SeenVertex &v0 = vertex[slot[0]], &v1 = vertex[slot[1]], &v2 = vertex[slot[2]];
      const Edge &e0 = edge[slot[3]], &e1 = edge[slot[4]], &e2 = edge[slot[5]];
      const Lanes product = v0.r * v1.r * v2.r;
      const Lanes height = dot(face.n, v0.x), across = face.area2 * height;
      const Lanes along = product + e0.between * v2.r + e1.between * v0.r + e2.between * v1.r;
      Lanes omega = 2 * angle_of(across, along);
      const Lanes high = magnitude(across), wide = magnitude(along);
      Measures measures;
      measures.of_layer = face.steep_around * (v0.r + v1.r + v2.r);
      measures.thin =
          Takes<L, O>::distances ? face.steep * (e0.distance + e1.distance + e2.distance) : measures.of_layer;
      const Lanes angle = longest_of(face) * e0.mean;
      const Lanes part =
          select(angle < kShort, L == Layers::Kelvin && O >= 1 ? splat(kOfShortKelvin) : kOfShort * angle, splat(1));
      measures.of_layer *= part;
      measures.thin *= part;
      if constexpr (L == Layers::Biharmonic) measures.of_distance = measures.thin * magnitude(height);
      const Mask far = ~widened(is_near);
      const Mask marked =
          (measures.template exceeds<L>(limits) | ((high < kNextToEdge * product) & (wide < kNextToEdge * product)) |
           ((along < Lanes{}) & (high < kNextToFace * wide)) | v0.near | v1.near | v2.near) &
          ~far;
      const Mask out = marked | far;
      squares.template add_squares<L>(measures, out);
      if constexpr (L == Layers::Biharmonic && O >= 1) measured.thin_below.add(measures.thin, out);
      const Three<Lanes>* const x[3] = {&v0.x, &v1.x, &v2.x};
      // The same code adds whole faces and parts of them, so that both round in the same way.
      const Edge* edges[3] = {&e0, &e1, &e2};
      Edge left[3];
      if (any(out)) [[unlikely]] {
        if (any(marked)) block.marks[block.marked++] = {f, bits_of(marked)};
        for (int e = 0; e < 3; ++e) {
          left[e] = without(out, *edges[e]);
          edges[e] = &left[e];
        }
        omega = select(out, Lanes{}, omega);
      }
      FaceTerms<L, O, Lanes, double>(face, x, omega, edges).add(f, beta, sums);
    }
  }
  measured.squares = squares;
}

/// Adds the faces that are far, and the terms of edges between these and near ones.
template <Layers L, int O>
void add_far_faces(const Block& block, const NearFaces& near) {
  const CageTables& cage = *block.cage;
  const Sums<Lanes> sums{reinterpret_cast<Lanes*>(block.columns), &block.layout};
  const auto* const point = reinterpret_cast<const Lanes*>(block.points);
  const Lanes beta = splat(block.beta.high);
  for_far_faces<L, O>(block, near, [&](int f, const Three<Lanes>& x, const FarMoments<L, O>& moments) {
    const FaceTable<double>& face = cage.face[f];
    FarFace<L, O>{face, dot(face.n, x), moments}.add(f, beta, sums);
  });
  if constexpr (O >= 1 || L == Layers::Kelvin)
    for (int e = 0; e < cage.edges; ++e)
      if (bytes_of(near.sign[e]) != 0)
        BorderEdge<L, O>(cage.edge[e], from_point(cage, point, cage.edge[e].from), *cage.line,
                         __builtin_convertvector(near.sign[e], Lanes), beta)
            .add(sums);
}

/// \param measured with limits that have been lowered, where this is done again
template <Layers L, int O>
void sum_faces(Block& block, MeasuredBlock& measured) {
  using Edge = EdgeTerms<Lanes, Takes<L, O>::further>;
  const CageTables& cage = *block.cage;
  auto* const vertex = static_cast<SeenVertex*>(block.scratch);
  auto* const edge = reinterpret_cast<Edge*>(vertex + cage.vertices);
  const NearFaces near =
      find_near_faces(block, edge + cage.edges, measured.rules, kRulesFirst<L, O>, kRulesFirst<L, O>);
  measured.faces = near.faces_of;
  measured.between = near.between;
  sum_faces_within<L, O>(block, near, measured);
  const Mask many = measured.squares.thin > kManyThin<L> * kManyThin<L>;
  if (any(many & near.between)) {
    take_all_rules(measured, many & near.between);
    return sum_faces<L, O>(block, measured);
  }
  if (any(many)) {
    Lanes& limit = measured.limits.thin;
    limit = select(many & (splat(kThinOfMany) < limit), splat(kThinOfMany), limit);
    sum_faces_within<L, O>(block, near, measured);
  }
  add_far_faces<L, O>(block, near);
}

}  // namespace cageproof::closed_form::batch::CAGEPROOF_SIMD
