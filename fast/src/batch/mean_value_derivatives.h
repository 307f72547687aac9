// SPDX-License-Identifier: MIT
// Weights of mean value coordinates with gradients and Hessians, a vector of points at a time, by derivatives of
// M = 2 d int Gamma r^-4 = -2 w ([T18] Eq 11 in its integral form), Gamma a corner's hat function with gradient g.
//
// With F = int r^-4 over the face, E = int Gamma r^-4 over an edge, K_n = int r^-n over an edge, nu an edge's outward
// normal within the plane, h its height over the projection, and sums over the edges:
//   2 d F = sum h K2/d = V,   Q = dV/dd = -V/d - 2 sum h K4,   dQ/dd = 2 V/d2 + 2 sum h K4/d + 8 d sum h K6,
//   within the plane:  grad M = V g - 2 d sum nu E,
//   across it:         q = Gamma Q - sum (nu g)(K2 - 2 d2 K4),   dq/dd = Gamma dQ/dd + sum (nu g)(6 d K4 - 8 d3 K6).
// Where the projection is beyond three heights of the edges, V = -d R, Q = R - 2 sum h K4 and dQ/dd = 8 d sum h K6 -
// 2 d S, with R = sum h int 1/(r2 rho2) and S = sum h int 1/(r4 rho2), cancel nothing.
#pragma once

#include "base_face.h"
#include "fast.h"
#include "leading.h"
#include "mean_value_edges.h"
#include "mean_values.h"
#include "steep_derivatives.h"

namespace cageproof::closed_form::batch::CAGEPROOF_SIMD {

/// Squares of distances from the edges within the plane, over the height's, above which a projection is beyond.
inline constexpr double kLowest = 9;

/// Roundings of a sum over a face's edges, over the sum of its terms' sizes.
inline constexpr double kOfSum = 0.125;

/// One face seen from the points.
template <int O>
class MeanValueFace {
 public:
  MeanValueFace(const CageTables& cage, const FaceTable<double>& face, const SeenVertex* const (&corner)[3],
                const MeanValueEdge* const (&side)[3], Lanes height)
      : cage_(cage), face_(face), side_(side) {
    const SeenHeights seen = seen_heights(face, corner, height);
    d_ = seen.d;
    const Lanes d2 = d_ * d_;
    Lanes flux{}, least = splat(1e300);
    for (int e = 0; e < 3; ++e) {
      h_[e] = seen.h[e];
      const Lanes second = h_[e] * side[e]->k2, fourth = h_[e] * side[e]->k4;
      flux += second;
      h4_ += fourth;
      sizes_.second += magnitude(second);
      sizes_.fourth += magnitude(fourth);
      if constexpr (O >= 2) {
        const Lanes sixth = h_[e] * side[e]->k6;
        h6_ += sixth;
        sizes_.sixth += magnitude(sixth);
      }
      const Lanes r0 = corner[e]->r, r1 = corner[(e + 1) % 3]->r;
      const Lanes end = select(r0 < r1, r0, r1);
      const Lanes away = select(side[e]->ends > Lanes{}, end * end - d2, h_[e] * h_[e]);
      least = select(away < least, away, least);
    }
    const Mask within = (h_[0] > Lanes{}) & (h_[1] > Lanes{}) & (h_[2] > Lanes{});
    const Mask low = low_ = ~within & (least > kLowest * d2);
    const Lanes over = 1 / d_;
    flux_ = flux;
    whole_ = flux * over;
    slope_ = -whole_ * over - 2 * h4_;
    if constexpr (O >= 2) bend_ = 2 * over * (whole_ * over + h4_) + 8 * d_ * h6_;
    if (any(low)) {
      Lanes fourth{}, sixth{};
      for (int e = 0; e < 3; ++e) {
        const InPlane rest = in_plane<O>(cage.edge[face.edge[e]].length, *side[e], h_[e], d_);
        fourth += h_[e] * rest.fourth;
        sixth += h_[e] * rest.sixth;
      }
      whole_ = select(low, -d_ * fourth, whole_);
      slope_ = select(low, fourth - 2 * h4_, slope_);
      if constexpr (O >= 2) bend_ = select(low, d_ * (8 * h6_ - 2 * sixth), bend_);
    }
  }

  Lanes height() const { return d_; }
  /// V
  Lanes total() const { return whole_; }
  /// About the errors that roundings of V, Q, dQ/dd and of sums over the edges cause in the weights and their
  /// derivatives.
  Roundings<O> roundings() const {
    const Lanes d = magnitude(d_), over = 1 / d;
    const Lanes slope = face_.steep * (side_[0]->k2 + side_[1]->k2 + side_[2]->k2);
    const Lanes hat[2] = {h_[1] * face_.hat[0], h_[2] * face_.hat[1]};
    const Lanes hats = magnitude(hat[0]) + magnitude(hat[1]) + magnitude(1 - hat[0] - hat[1]);
    const Lanes whole = select(low_, d * sizes_.fourth, sizes_.second * over);
    const Lanes across = select(low_, sizes_.fourth, whole * over) + 2 * sizes_.fourth;
    Roundings<O> left;
    const auto larger = [](Lanes a, Lanes b) { return select(a < b, b, a); };
    left.of[0] = larger(d * slope, kOfSum * whole * hats);
    left.of[1] = larger(slope, kOfSum * (whole * face_.steep + across * hats));
    if constexpr (O >= 2) {
      const Lanes bend = select(low_, d * sizes_.sixth, over * (whole * over + sizes_.fourth)) + 8 * d * sizes_.sixth;
      left.of[2] = kOfSum * (across * face_.steep + bend * hats);
    }
    return left;
  }
  /// Keeps the face as that which some points are seen from.
  void keep(Mask mine, BaseFace& base) const {
    const auto take = [&](SpaceJet& to, Lanes value, auto gradient, auto hessian) {
      to.value = select(mine, value, to.value);
      for (int i = 0; i < 3; ++i) to.gradient[i] = select(mine, gradient(i), to.gradient[i]);
      if constexpr (O >= 2)
        for (int i = 0; i < 6; ++i) to.hessian[i] = select(mine, hessian(i), to.hessian[i]);
    };
    const auto nothing = [](int) { return Lanes{}; };
    const double* const n = face_.n;
    base.seen |= mine;
    base.beside[0] = select(mine, magnitude(slope_), base.beside[0]);
    if constexpr (O >= 2) base.beside[1] = select(mine, magnitude(bend_), base.beside[1]);
    take(
        base.height, d_, [&](int i) { return splat(n[i]); }, nothing);
    const Weight sum = without_total().all();  // derivatives of V that have none of its powers of the height
    // d V, whose derivatives across the plane are -2 d sum h K4 and -2 sum h K4 + 8 d2 sum h K6.
    const Lanes rise = -2 * d_ * h4_, bend = -2 * h4_ + 8 * d_ * d_ * h6_;
    take(
        base.total, -flux_, [&](int i) { return -(d_ * sum.gradient[i] + rise * n[i]); },
        [&](int at) {
          const int i = kHessianFirst[at], j = kHessianSecond[at];
          return -(d_ * sum.hessian[at] + sum.gradient[i] * n[j] + sum.gradient[j] * n[i] + bend * (n[i] * n[j]));
        });
    Lanes last_hat = splat(1);
    Weight last{};
    for (int k = 0; k < 3; ++k) {
      base.vertex[k] = select(mine, splat(face_.vertex[k]), base.vertex[k]);
      const Lanes hat = k < 2 ? h_[k + 1] * face_.hat[k] : last_hat;
      last_hat -= hat;
      const auto slope = [&](int i) { return k < 2 ? face_.g[k][i] : -face_.g[0][i] - face_.g[1][i]; };
      take(
          base.hat[k], hat, [&](int i) { return splat(slope(i)); }, nothing);
      const Weight rest = k < 2 ? rest_of_corner(k, hat, sum) : last;
      last.value -= rest.value;
      for (int i = 0; i < 3; ++i) last.gradient[i] -= rest.gradient[i];
      for (int i = 0; i < 6; ++i) last.hessian[i] -= rest.hessian[i];
      take(
          base.rest[k], -rest.value, [&](int i) { return -rest.gradient[i]; }, [&](int i) { return -rest.hessian[i]; });
    }
  }
  /// Adds -M of the three corners, and their derivatives. \param mine points that the face is added for
  void add(Mask mine, const Block& block) const {
    auto* const columns = reinterpret_cast<Lanes*>(block.columns);
    const auto at = [&](int order, int k, int size) {
      return columns + block.layout.first[order][0] + face_.vertex[k] * size;
    };
    Weight last = all();
    for (int k = 0; k < 2; ++k) {
      const Weight weight = of_corner(k);
      put(mine, weight, at, k);
      last.value -= weight.value;
      for (int i = 0; i < 3; ++i) last.gradient[i] -= weight.gradient[i];
      if constexpr (O >= 2)
        for (int i = 0; i < 6; ++i) last.hessian[i] -= weight.hessian[i];
    }
    put(mine, last, at, 2);
  }

 private:
  struct Weight {
    Lanes value, gradient[3], hessian[6];
  };

  template <class At>
  static void put(Mask mine, const Weight& weight, At at, int k) {
    *at(0, k, 1) -= select(mine, weight.value, Lanes{});
    Lanes* const gradient = at(1, k, 3);
    for (int i = 0; i < 3; ++i) gradient[i] -= select(mine, weight.gradient[i], Lanes{});
    if constexpr (O >= 2) {
      Lanes* const hessian = at(2, k, 6);
      for (int i = 0; i < 6; ++i) hessian[i] -= select(mine, weight.hessian[i], Lanes{});
    }
  }

  /// Adds an edge's part to derivatives within the plane and to the mixed ones.
  void add_edge(int e, Lanes fourth, Lanes sixth, Lanes slope, Weight& weight, Lanes (&mixed)[3]) const {
    for (int i = 0; i < 3; ++i) weight.gradient[i] -= 2 * d_ * fourth * face_.nu[e][i];
    if constexpr (O >= 2) {
      const double* const u = cage_.edge[face_.edge[e]].u;
      const double* const nu = face_.nu[e];
      const Lanes across = -8 * d_ * sixth * h_[e], along = -d_ * slope;
      for (int i = 0; i < 3; ++i) mixed[i] += (8 * d_ * d_ * sixth - 2 * fourth) * nu[i];
      for (int i = 0, at = 0; i < 3; ++i)
        for (int j = i; j < 3; ++j, ++at)
          weight.hessian[at] += across * (nu[i] * nu[j]) + along * (nu[i] * u[j] + nu[j] * u[i]);
    }
  }
  void add_normal(Lanes slope, Lanes bend, const Lanes (&mixed)[3], Weight& weight) const {
    for (int i = 0; i < 3; ++i) weight.gradient[i] += slope * face_.n[i];
    if constexpr (O >= 2)
      for (int i = 0, at = 0; i < 3; ++i)
        for (int j = i; j < 3; ++j, ++at)
          weight.hessian[at] += mixed[i] * face_.n[j] + (mixed[j] + bend * face_.n[j]) * face_.n[i];
  }

  // The three corners' sum, whose hat function is one.
  Weight all() const {
    Weight weight{};
    weight.value = whole_;
    Lanes mixed[3] = {};
    for (int e = 0; e < 3; ++e)
      add_edge(e, side_[e]->k4, side_[e]->k6, side_[e]->slope[0] + side_[e]->slope[1], weight, mixed);
    add_normal(slope_, bend_, mixed, weight);
    return weight;
  }

  Weight of_corner(int k) const {
    Weight weight{};
    const double(&g)[3] = face_.g[k];
    const Lanes hat = h_[k + 1] * face_.hat[k];
    Lanes second{}, fourth{}, sixth{};  // sums of (nu g) K
    for (int e = 0; e < 3; ++e) {
      second += side_[e]->k2 * face_.across[k][e];
      fourth += side_[e]->k4 * face_.across[k][e];
      if constexpr (O >= 2) sixth += side_[e]->k6 * face_.across[k][e];
    }
    weight.value = hat * whole_ - d_ * second;
    for (int i = 0; i < 3; ++i) weight.gradient[i] = whole_ * g[i];
    Lanes mixed[3] = {};
    if constexpr (O >= 2) {
      Lanes p[3];  // the derivative of V within the plane
      for (int i = 0; i < 3; ++i) {
        mixed[i] = slope_ * g[i];
        p[i] =
            -2 * d_ * (side_[0]->k4 * face_.nu[0][i] + side_[1]->k4 * face_.nu[1][i] + side_[2]->k4 * face_.nu[2][i]);
      }
      for (int i = 0, at = 0; i < 3; ++i)
        for (int j = i; j < 3; ++j, ++at) weight.hessian[at] = 0.5 * (g[i] * p[j] + g[j] * p[i]);
    }
    for (const int e : {k, (k + 2) % 3}) {
      // The corner is where the edge begins in the face's own direction, or where it ends.
      const int end = (e == k) == (face_.along[e] > 0) ? 0 : 1;
      add_edge(e, side_[e]->hat[end], side_[e]->sixth[end], side_[e]->slope[end], weight, mixed);
    }
    const Lanes bend = O >= 2 ? hat * bend_ + d_ * (6 * fourth - 8 * d_ * d_ * sixth) : Lanes{};
    add_normal(hat * slope_ - second + 2 * d_ * d_ * fourth, bend, mixed, weight);
    return weight;
  }

  MeanValueFace without_total() const {
    MeanValueFace rest = *this;
    rest.whole_ = rest.slope_ = rest.bend_ = Lanes{};
    return rest;
  }
  // A corner's weight less its hat function times V. \param sum all() without_total()
  Weight rest_of_corner(int k, Lanes hat, const Weight& sum) const {
    Weight rest = without_total().of_corner(k);
    const double(&g)[3] = face_.g[k];
    // Within the plane V's derivative takes part in the Hessian of the product that is taken off; the mixed ones of it
    // are all of V's slope across.
    for (int i = 0; i < 3; ++i) rest.gradient[i] -= hat * sum.gradient[i];
    if constexpr (O >= 2)
      for (int at = 0; at < 6; ++at) {
        const int i = kHessianFirst[at], j = kHessianSecond[at];
        rest.hessian[at] -= hat * sum.hessian[at] + g[i] * sum.gradient[j] + g[j] * sum.gradient[i];
      }
    return rest;
  }

  const CageTables& cage_;
  const FaceTable<double>& face_;
  const MeanValueEdge* const (&side_)[3];
  Lanes d_{}, h_[3] = {}, h4_{}, h6_{};
  struct {
    Lanes second{}, fourth{}, sixth{};
  } sizes_;  // sums of |h K|
  Mask low_{};
  Lanes flux_{};                      // d V
  Lanes whole_{}, slope_{}, bend_{};  // V, Q, dQ/dd
};

/// Distances from edges and corners, over those that `near` stands for, below which derivatives are left to others.
template <int O>
inline constexpr double kLeftBeside = O == 1 ? 0.25 : 1;

/// Whether a point is so near to an edge or a corner that its derivatives are left to others.
template <int O>
Mask is_left_beside(const CageTables& cage, const FaceTable<double>& face, const SeenVertex* const (&corner)[3],
                    const MeanValueEdge* const (&side)[3]) {
  Mask left{};
  for (int k = 0; k < 3; ++k) {
    const double close = kLeftBeside<O> * kBesideEdge * cage.edge[face.edge[k]].length;
    left |= corner[k]->near & (corner[k]->r < splat(kLeftBeside<O> * cage.reach[face.vertex[k]]));
    left |= side[k]->near & (side[k]->square < splat(close * close));
  }
  return left;
}

/// Adds the faces that are near, and lists those that need more digits. \param from the faces that points are seen from
template <int O>
void sum_mean_value_faces(Block& block, const NearFaces& faces, const SeenVertex* vertex, const MeanValueEdge* edge,
                          const Lanes* height, Lanes from, SteepDerivatives<O>& steep) {
  const CageTables& cage = *block.cage;
  BaseFace& base = *static_cast<BaseFace*>(block.measured);
  base = BaseFace{};
  Mask left{};
  const Mask whole = mask_of(block.whole);
  block.marked = block.beyond_marked = 0;
  for (int place = 0; place < faces.count; ++place) {
    const int f = faces.faces[place];
    const FaceTable<double>& face = cage.face[f];
    const Mask far = ~widened(faces.is_near(f));
    const SeenVertex* const corner[3] = {vertex + face.vertex[0], vertex + face.vertex[1], vertex + face.vertex[2]};
    const MeanValueEdge* const side[3] = {edge + face.edge[0], edge + face.edge[1], edge + face.edge[2]};
    const MeanValueFace<O> seen(cage, face, corner, side, height[f]);
    const Roundings<O> roundings = seen.roundings();
    const Mask near =
        (corner[0]->near | corner[1]->near | corner[2]->near | side[0]->near | side[1]->near | side[2]->near) & ~far;
    const Mask mine = from == splat(f);
    const Mask many = whole | (steep.exceeded(face.steep, roundings) & ~mine), marked = (near | many) & ~far;
    const Mask out = marked | far;
    if (any(near)) left |= near & is_left_beside<O>(cage, face, corner, side);
    if (any(mine)) {
      // A height below kLostHeight is only rounding: the point may be on the face.
      const Lanes d = magnitude(seen.height());
      left |= mine & ((marked & (d < splat(kLeftBeside<O> * kBesideEdge * __builtin_sqrt(face.area2)))) |
                      (d < splat(kLostHeight)));
      seen.keep(mine & ~marked, base);
    }
    steep.count(face.steep, out | mine, roundings, select(far, Lanes{}, seen.total()));
    seen.add(~(out | mine), block);
    if (!any(marked)) [[likely]]
      continue;
    const unsigned points = bits_of(marked), more = cage.folded[f] != 0 ? bits_of(near) : 0;
    if (more != 0) block.beyond[block.beyond_marked++] = {f, more};
    if (points != more) block.marks[block.marked++] = {f, points & ~more};
  }
  block.left = bits_of(left);
}

template <int O>
void sum_mean_value_derivatives(Block& block) {
  const CageTables& cage = *block.cage;
  auto* const vertex = static_cast<SeenVertex*>(block.scratch);
  auto* const edge = reinterpret_cast<MeanValueEdge*>(vertex + cage.vertices);
  auto* const height = reinterpret_cast<Lanes*>(edge + cage.edges);
  auto* const columns = reinterpret_cast<Lanes*>(block.columns);
  SteepDerivatives<O> steep;
  Attempts attempts;
  fine_heights(block, height);
  while (attempts.again) {
    const NearFaces near =
        find_near_faces(block, height + cage.faces, attempts.rules, kQuickMeanValueRules[O], kFewMeanValueRules[O]);
    see_vertices(block, near, vertex);
    for (int e = 0; e < cage.edges; ++e) {
      if (near.edge[e] == 0) continue;
      const EdgeTable<double>& table = cage.edge[e];
      edge[e] = mean_value_edge<O>(table, vertex[table.from], vertex[table.to]);
    }
    for (int c = 0; c < block.layout.count; ++c) columns[c] = Lanes{};
    const Lanes from = base_faces(cage, near, vertex, height);
    steep.start(cage, add_far_mean_values<O>(block, near, height), from);
    sum_mean_value_faces<O>(block, near, vertex, edge, height, from, steep);
    steep.hold(block);
    steep.lower(attempts.next(steep.many(), near), near.faces_of);
  }
}

/// Divides weights by their sum, by the quotient rule; leaves points to others whose sums are no numbers.
inline void normalise(Block& block) {
  auto* const columns = reinterpret_cast<Lanes*>(block.columns);
  constexpr int kept[3] = {1, 3, 6}, first[6] = {0, 0, 0, 1, 1, 2}, second[6] = {0, 1, 2, 1, 2, 2};
  if (block.order > 0) {
    const BaseFace& base = *static_cast<const BaseFace*>(block.measured);
    if (any(base.seen)) {
      if (block.order == 1) normalise_from_faces<1>(block, base);
      else normalise_from_faces<2>(block, base);
      return complete(columns, block.layout, kept, block.order, block.cage->vertices);
    }
  }
  Lanes sum[3][6] = {};
  Mask left = mask_of(block.left);
  for (int o = 0; o <= block.order; ++o) {
    const Lanes* const from = columns + block.layout.first[o][0];
    for (int v = 0; v < block.cage->vertices; ++v)
      for (int i = 0; i < kept[o]; ++i) sum[o][i] += from[kept[o] * v + i];
    for (int i = 0; i < kept[o]; ++i) left |= ~((sum[o][i] - sum[o][i]) == Lanes{});
  }
  const Lanes over = 1 / sum[0][0];
  for (int v = 0; v < block.cage->vertices; ++v) {
    Lanes& value = columns[block.layout.first[0][0] + v];
    value /= sum[0][0];
    if (block.order == 0) continue;
    Lanes* const gradient = columns + block.layout.first[1][0] + 3 * v;
    for (int i = 0; i < 3; ++i) gradient[i] = (gradient[i] - value * sum[1][i]) * over;
    if (block.order == 1) continue;
    Lanes* const hessian = columns + block.layout.first[2][0] + 6 * v;
    for (int i = 0; i < 6; ++i) {
      const int a = first[i], b = second[i];
      hessian[i] = (hessian[i] - value * sum[2][i] - gradient[a] * sum[1][b] - gradient[b] * sum[1][a]) * over;
    }
  }
  complete(columns, block.layout, kept, block.order, block.cage->vertices);
  block.left = bits_of(left);
}

}  // namespace cageproof::closed_form::batch::CAGEPROOF_SIMD
