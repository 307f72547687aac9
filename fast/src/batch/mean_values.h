// SPDX-License-Identifier: MIT
// Mean value coordinates of a triangle cage, a vector of points at a time: values ([T18] Eq 11, 13).
//
// With d the height, K2 the integral of r^-2 over an edge (its angle over the distance of its line), F = sum h K2 and
// G_k = sum (nu g_k) K2, a face's weights are w_k = (d G_k - Gamma_k F/d)/2. Near the face's plane F/d cancels beyond
// the face, and is taken as -d sum rest, rest = h int 1/(r^2 rho^2), rho the distance from the point's projection: the
// amount by which the height shrinks each angle in the plane.
#pragma once

#include "careful_entries.h"
#include "far_mean_values.h"
#include "fast.h"
#include "mean_value_edges.h"

namespace cageproof::closed_form::batch::CAGEPROOF_SIMD {

/// One edge seen from the points.
struct SeenEdge {
  Lanes angle_over;  ///< K2
  Lanes square;      ///< squared distance of the line
  Lanes distance;    ///< its root
  Lanes ends;        ///< s0 s1
};

/// Heights below this, over the distance of a corner, take the form next to the plane; and where roundings of those
/// above it add up.
inline constexpr double kNextToPlane = 0x1p-9, kLow = 0.25;
/// How much rounding steep faces may leave in values.
inline constexpr double kSteepValues = 20;
/// Distances from an edge's line, or from a corner, below this times the edge are left to others; likewise heights
/// within a face.
inline constexpr double kLeftAlone = 0x1p-30;
inline SeenEdge seen_edge(const EdgeTable<double>& e, const SeenVertex& a, const SeenVertex& b) {
  const SeenLine line = seen_line(e, a, b);
  SeenEdge seen;
  seen.distance = line.distance;
  seen.square = seen.distance * seen.distance;
  seen.ends = line.s0 * line.s1;
  seen.angle_over = angle_of(seen.distance * e.length, dot(a.x, b.x)) / seen.distance;
  return seen;
}

/// Next to a face's plane, where another face may be behind it, its edges' heights and distances are rounded once.
inline void see_finely(const Block& block, int f, const SeenVertex* const (&corner)[3], Mask where, Lanes d,
                       const SeenEdge* const (&side)[3], SeenEdge (&finely)[3], Lanes (&h)[3]) {
  Lanes fine[3];
  fine_edge_heights(block, f, fine);
  for (int e = 0; e < 3; ++e) {
    const double length = block.cage->edge[block.cage->face[f].edge[e]].length;
    SeenEdge& to = finely[e] = *side[e];
    h[e] = select(where, fine[e], h[e]);
    const Lanes square = fine[e] * fine[e] + d * d, distance = root(square);
    const Lanes angle = angle_of(distance * length, dot(corner[e]->x, corner[(e + 1) % 3]->x));
    // Where the distance is zero, the edge's own form keeps its integral.
    const Mask mine = where & (distance > Lanes{});
    to.square = select(mine, square, to.square);
    to.distance = select(mine, distance, to.distance);
    to.angle_over = select(mine, angle / distance, to.angle_over);
  }
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

/// The sum of the roundings of steep faces. A face's weights are differences of |d| int r^-2 over its edges times the
/// slopes of its hat functions. They keep the rounding of these terms, while the weights' total may be much smaller.
class Steepness {
 public:
  /// \param most what the root of the sum of squares may be of the total
  explicit Steepness(double most) : most_(most) {}
  Lanes of(const FaceTable<double>& face, Lanes height, Lanes k2) const { return magnitude(height) * face.steep * k2; }
  /// Before faces are summed, again. \param total the weights of those that take rules
  void start(Lanes total) {
    squares_ = Lanes{};
    total_ = total;
  }
  /// \param steepness of a face that is added in double \param total its weights'
  void count(Lanes steepness, Lanes total) {
    squares_ += steepness * steepness;
    total_ += total;
  }
  /// Below which a height over the distance of a corner is next to the plane.
  Lanes low() const { return low_; }
  Mask exceeds(Lanes steepness) const { return steepness > limit_; }
  /// Where too much is left.
  Mask many() const {
    const Lanes most = most_ * magnitude(total_);
    return squares_ > most * most;
  }
  /// Sets a limit for points, so that it no longer is when faces are summed again.
  void lower(Mask points) {
    limit_ = select(points, (most_ / 16) * magnitude(total_), limit_);
    low_ = select(points, splat(kLow), low_);
  }

 private:
  double most_;
  Lanes squares_{}, total_{}, limit_ = splat(1e300), low_ = splat(kNextToPlane);
};

/// How often faces are summed: first by the quick rules, then, for points that this leaves too much rounding of, by all
/// rules, then with a limit beyond which faces are left to others.
struct Attempts {
  Small rules = Small{} + static_cast<signed char>(kFirstRules);
  Mask limited{};

  /// \param many points whose sums are too large \return those of them that get a limit
  Mask next(Mask many, const NearFaces& near) {
    const Mask ruled = many & near.between;
    for (int i = 0; i < kLanes; ++i)
      if (ruled[i] != 0) rules[i] = kFarRules;
    const Mask fresh = many & ~ruled & ~limited;
    limited |= fresh;
    again = any(ruled | fresh);
    return fresh;
  }
  bool again = true;
};

/// The number of rules in use at first, by order: at points next to faces those that are quicker than closed forms, at
/// other points those that fine cages need.
inline constexpr int kFewMeanValueRules[3] = {2, 4, 4}, kQuickMeanValueRules[3] = {5, kQuickRules, kQuickRules};

/// Adds the faces that are near. \return the points that are left to others
inline Mask sum_mean_values_within(Block& block, const NearFaces& faces, const SeenVertex* vertex, const SeenEdge* edge,
                                   const Lanes* heights, Steepness& steep) {
  const CageTables& cage = *block.cage;
  auto* const columns = reinterpret_cast<Lanes*>(block.columns);
  const Mask whole = mask_of(block.whole);
  Mask left{};
  block.marked = block.beyond_marked = 0;
  for (int place = 0; place < faces.count; ++place) {
    const int f = faces.faces[place];
    const FaceTable<double>& face = cage.face[f];
    const Mask far = ~widened(faces.is_near(f));
    const SeenVertex* const corner[3] = {vertex + face.vertex[0], vertex + face.vertex[1], vertex + face.vertex[2]};
    const SeenEdge* side[3] = {edge + face.edge[0], edge + face.edge[1], edge + face.edge[2]};
    SeenHeights seen = seen_heights(face, corner, heights[f]);
    Lanes(&h)[3] = seen.h;
    const Lanes d = seen.d, height = magnitude(d);
    const Mask near_plane = height < steep.low() * corner[0]->r;
    SeenEdge near_side[3];
    if (any(near_plane)) {
      see_finely(block, f, corner, near_plane, d, side, near_side, h);
      for (int e = 0; e < 3; ++e) side[e] = near_side + e;
    }
    Lanes angle[3] = {side[0]->angle_over, side[1]->angle_over, side[2]->angle_over};
    Lanes flux{}, sizes{};
    for (int e = 0; e < 3; ++e) {
      const Lanes term = h[e] * side[e]->angle_over;
      flux += term;
      sizes += magnitude(term);
    }
    Lanes over = flux / d, rounding = sizes / height;
    if (any(near_plane)) {
      const Mask within = (h[0] >= Lanes{}) & (h[1] >= Lanes{}) & (h[2] >= Lanes{});
      left |= within & (height < kLeftAlone * corner[0]->r) & ~far;
      // Within the face, and where the projection is next to its border, F/d cancels little.
      Mask beyond = near_plane & ~within;
      for (int e = 0; e < 3; ++e) {
        const Lanes r0 = corner[e]->r, r1 = corner[(e + 1) % 3]->r, end = select(r0 < r1, r0, r1);
        const Lanes away = select(side[e]->ends > Lanes{}, end * end - d * d, h[e] * h[e]);
        beyond &= away > d * d;
      }
      if (any(beyond)) {
        Lanes rest{};
        for (int e = 0; e < 3; ++e) rest += in_plane_rest(cage.edge[face.edge[e]], *side[e], h[e], d * d);
        over = select(beyond, -d * rest, over);
        rounding = select(beyond, Lanes{}, rounding);
      }
    }
    const Lanes hat[2] = {h[1] * face.hat[0], h[2] * face.hat[1]};
    // F/d is shared out by the hat functions, which are large next to a thin face.
    rounding *= magnitude(hat[0]) + magnitude(hat[1]) + magnitude(1 - hat[0] - hat[1]);
    const Lanes steepness = steep.of(face, d, angle[0] + angle[1] + angle[2]);
    Mask near{};
    if (cage.folded[f] != 0)
      for (int e = 0; e < 3; ++e) {
        const Lanes close = splat(kBesideEdge * cage.edge[face.edge[e]].length);
        near |= corner[e]->near | ((side[e]->ends < Lanes{}) & (side[e]->distance < close));
      }
    near &= ~far;
    const Mask marked = (whole | near | steep.exceeds(steepness)) & ~far, out = marked | far;
    steep.count(select(out, Lanes{}, steepness + rounding), select(far, Lanes{}, over));
    if (any(out)) {
      const unsigned points = bits_of(marked), more = bits_of(near);
      if (more != 0) block.beyond[block.beyond_marked++] = {f, more};
      if (points != more) block.marks[block.marked++] = {f, points & ~more};
      for (int e = 0; e < 3; ++e) angle[e] = select(out, Lanes{}, angle[e]);
      over = select(out, Lanes{}, over);
    }
    Lanes last = -over;  // the three weights' sum, twice
    for (int k = 0; k < 2; ++k) {
      const Lanes across = angle[0] * face.across[k][0] + angle[1] * face.across[k][1] + angle[2] * face.across[k][2];
      const Lanes weight = d * across - hat[k] * over;
      columns[face.vertex[k]] += weight;
      last -= weight;
    }
    columns[face.vertex[2]] += last;
  }
  return left;
}

/// Sees a cage's near vertices from the points.
/// \return points that are so near to one that they are left to others
inline Mask see_vertices(const Block& block, const NearFaces& near, SeenVertex* vertex) {
  const CageTables& cage = *block.cage;
  const auto* const point = reinterpret_cast<const Lanes*>(block.points);
  Mask left{};
  for (int v = 0; v < cage.vertices; ++v) {
    if (near.vertex[v] == 0) continue;
    SeenVertex& seen = vertex[v];
    for (int i = 0; i < 3; ++i) seen.x[i] = cage.vertex[3 * v + i] - point[i];
    seen.r = root(dot(seen.x, seen.x));
    seen.near = less(seen.r, splat(cage.reach[v]));
    left |= less(seen.r, splat(kLeftAlone * cage.reach[v]));
  }
  return left;
}

inline void sum_mean_values(Block& block) {
  const CageTables& cage = *block.cage;
  auto* const vertex = static_cast<SeenVertex*>(block.scratch);
  auto* const edge = reinterpret_cast<SeenEdge*>(vertex + cage.vertices);
  auto* const height = reinterpret_cast<Lanes*>(edge + cage.edges);
  auto* const columns = reinterpret_cast<Lanes*>(block.columns);
  Steepness steep(kSteepValues);
  Attempts attempts;
  fine_heights(block, height);
  while (attempts.again) {
    const NearFaces near =
        find_near_faces(block, height + cage.faces, attempts.rules, kQuickMeanValueRules[0], kFewMeanValueRules[0]);
    Mask left = see_vertices(block, near, vertex);
    for (int e = 0; e < cage.edges; ++e) {
      if (near.edge[e] == 0) continue;
      const EdgeTable<double>& table = cage.edge[e];
      edge[e] = seen_edge(table, vertex[table.from], vertex[table.to]);
      left |= less(edge[e].distance, splat(kLeftAlone * table.length));
    }
    for (int v = 0; v < cage.vertices; ++v) columns[v] = Lanes{};
    steep.start(add_far_mean_values<0>(block, near, height));
    left |= sum_mean_values_within(block, near, vertex, edge, height, steep);
    block.left = bits_of(left);
    steep.lower(attempts.next(steep.many(), near));
  }
}

}  // namespace cageproof::closed_form::batch::CAGEPROOF_SIMD
