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

/// How many rules are taken before roundings are known: those that are quicker than closed forms, and of Kelvin's
/// derivatives, which edge_tails.h does not reduce, those that keep their digits.
template <Layers L, int O>
inline constexpr int kRulesFirst = L == Layers::Kelvin&& O >= 1 ? 5 : 2;

/// What a face that is small for its distance leaves of rounding, of what it does next to it: edge_tails.h takes off
/// what its edges' integrals have in common, so that they cancel by its circumference over the distance, times this.
/// Roundings of such faces are as many and as random as the faces. At least a third of what they are held to is the
/// slope of the coordinates, which is at least twice these over the distance.
inline constexpr double kOfShort = 0.05;
/// The same of derivatives of Kelvin's layers, whatever the distance.
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

/// Sums over the faces that are near, and lists those that need more digits, as the limits say.
template <Layers L, int O>
void sum_faces_within(Block& block, const NearFaces& near, const SeenVertex* vertex,
                      const EdgeTerms<Lanes, Takes<L, O>::further>* edge, MeasuredBlock& measured) {
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
  for (int place = 0; place < near.count; ++place) {
    const int f = near.faces[place];
    const FaceTable<double>& face = cage.face[f];
    const SeenVertex &v0 = vertex[face.vertex[0]], &v1 = vertex[face.vertex[1]], &v2 = vertex[face.vertex[2]];
    const Edge &e0 = edge[face.edge[0]], &e1 = edge[face.edge[1]], &e2 = edge[face.edge[2]];
    const Lanes product = v0.r * v1.r * v2.r;
    const Lanes height = dot(face.n, v0.x), across = face.area2 * height;
    const Lanes along = product + e0.between * v2.r + e1.between * v0.r + e2.between * v1.r;
    const Lanes omega = 2 * angle_of(across, along);
    const Lanes high = magnitude(across), wide = magnitude(along);
    Measures measures;
    measures.of_layer = face.steep_around * (v0.r + v1.r + v2.r);
    measures.thin = Takes<L, O>::distances ? face.steep * (e0.distance + e1.distance + e2.distance) : measures.of_layer;
    // Five times its edges are shorter than the sums of their ends' distances.
    const double around = face.length[0] + face.length[1] + face.length[2];
    const Mask brief = ((5 * face.length[0]) * e0.mean < splat(2)) & ((5 * face.length[1]) * e1.mean < splat(2)) &
                       ((5 * face.length[2]) * e2.mean < splat(2));
    const Lanes part =
        select(brief, L == Layers::Kelvin && O >= 1 ? splat(kOfShortKelvin) : (kOfShort * around) * e0.mean, splat(1));
    measures.of_layer *= part;
    measures.thin *= part;
    if constexpr (L == Layers::Biharmonic) measures.of_distance = measures.thin * magnitude(height);
    const Mask far = ~widened(near.is_near(f));
    const Mask marked = (measures.exceeds(limits) | ((high < kNextToEdge * product) & (wide < kNextToEdge * product)) |
                         ((along < Lanes{}) & (high < kNextToFace * wide)) | v0.near | v1.near | v2.near) &
                        ~far;
    const Mask out = marked | far;
    squares.add_squares(measures, out);
    if constexpr (L == Layers::Biharmonic && O >= 1) measured.thin_below.add(measures.thin, out);
    const Three<Lanes>* const x[3] = {&v0.x, &v1.x, &v2.x};
    if (!any(out)) [[likely]] {
      const Edge* const edges[3] = {&e0, &e1, &e2};
      FaceTerms<L, O, Lanes, double>(face, x, omega, edges).add(f, beta, sums);
      continue;
    }
    if (any(marked)) block.marks[block.marked++] = {f, bits_of(marked)};
    const Edge left[3] = {without(out, e0), without(out, e1), without(out, e2)};
    const Edge* const edges[3] = {&left[0], &left[1], &left[2]};
    FaceTerms<L, O, Lanes, double>(face, x, select(out, Lanes{}, omega), edges).add(f, beta, sums);
  }
  measured.squares = squares;
}

/// Adds the faces that are far, and what edges between these and near ones have.
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
  const auto* const point = reinterpret_cast<const Lanes*>(block.points);
  const Mask whole = mask_of(block.whole);
  const NearFaces near =
      find_near_faces(block, edge + cage.edges, measured.rules, kRulesFirst<L, O>, kRulesFirst<L, O>);
  for (int v = 0; v < cage.vertices; ++v) {
    if (near.vertex[v] == 0) continue;
    SeenVertex& seen = vertex[v];
    for (int i = 0; i < 3; ++i) seen.x[i] = cage.vertex[3 * v + i] - point[i];
    seen.r = root(dot(seen.x, seen.x));
    seen.near = less(seen.r, splat(cage.reach[v])) | whole;
  }
  for (int e = 0; e < cage.edges; ++e) {
    if (near.edge[e] == 0) continue;
    const EdgeTable<double>& table = cage.edge[e];
    const SeenVertex &a = vertex[table.from], &b = vertex[table.to];
    edge[e] = edge_terms<L, O, Lanes, double>(table, a.x, b.x, a.r, b.r);
  }
  measured.faces = near.faces_of;
  measured.between = near.between;
  sum_faces_within<L, O>(block, near, vertex, edge, measured);
  const Mask many = measured.squares.thin > kManyThin<L> * kManyThin<L>;
  if (any(many & near.between)) {
    take_all_rules(measured, many & near.between);
    return sum_faces<L, O>(block, measured);
  }
  if (any(many)) {
    Lanes& limit = measured.limits.thin;
    limit = select(many & (splat(kThinOfMany) < limit), splat(kThinOfMany), limit);
    sum_faces_within<L, O>(block, near, vertex, edge, measured);
  }
  add_far_faces<L, O>(block, near);
}

}  // namespace cageproof::closed_form::batch::CAGEPROOF_SIMD
