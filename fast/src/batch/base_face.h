// SPDX-License-Identifier: MIT
// The face that a point is next to, B, and mean value coordinates seen from it, a vector of points at a time. The
// face's weights are V/2 times its hat functions b_k, which its gradients continue off the plane, and what is left of
// them; the sum V grows like one over the height d, so that derivatives of w/W lose powers of it. What is seen from the
// face loses nothing, since V d is smooth:
//   lambda_k = b_k + d N_k/(d W),   N_k = w_k - b_k W,   of the face itself w_k - b_k V: the terms without V.
#pragma once

#include "fast.h"
#include "mean_value_edges.h"
#include "near_faces.h"

namespace cageproof::closed_form::batch::CAGEPROOF_SIMD {

/// Heights over a face, over the root of twice its area, below which points within are seen from it.
inline constexpr double kSeenFromFace = 0x1p-3;
/// Heights over a face, in the same unit, below which they are lost to the rounding of its plane, so that it cannot be
/// known whether a point is on the face.
inline constexpr double kLostHeight = 0x1p-92;

/// A function with gradient, and Hessian as xx, xy, xz, yy, yz, zz.
struct SpaceJet {
  Lanes value{}, gradient[3] = {}, hessian[6] = {};
};

/// The two axes of each entry of a Hessian.
inline constexpr int kHessianFirst[6] = {0, 0, 0, 1, 1, 2}, kHessianSecond[6] = {0, 1, 2, 1, 2, 2};

template <int O>
SpaceJet product_of(const SpaceJet& a, const SpaceJet& b) {
  SpaceJet c;
  c.value = a.value * b.value;
  for (int i = 0; i < 3; ++i) c.gradient[i] = a.gradient[i] * b.value + a.value * b.gradient[i];
  if constexpr (O >= 2)
    for (int at = 0; at < 6; ++at) {
      const int i = kHessianFirst[at], j = kHessianSecond[at];
      c.hessian[at] = a.hessian[at] * b.value + a.gradient[i] * b.gradient[j] + a.gradient[j] * b.gradient[i] +
                      a.value * b.hessian[at];
    }
  return c;
}

/// The face that each point is seen from, in the point's terms; zero for points without one.
struct BaseFace {
  Mask seen{};
  Lanes vertex[3] = {splat(-1), splat(-1), splat(-1)};
  SpaceJet height;       ///< d
  SpaceJet hat[3];       ///< b_k
  SpaceJet rest[3];      ///< w_k - b_k V, in the scale of the columns
  SpaceJet total;        ///< d V, in the same scale
  Lanes beside[2] = {};  ///< V's derivatives across the plane, which the columns do not have
};

/// The face that each point is seen from, the nearest of those that are not far; -1 for points next to no face.
inline Lanes base_faces(const CageTables& cage, const NearFaces& faces, const SeenVertex* vertex, const Lanes* height) {
  Lanes base = splat(-1), least = splat(1e300);
  for (int place = 0; place < faces.count; ++place) {
    const int f = faces.faces[place];
    const FaceTable<double>& face = cage.face[f];
    const Lanes d = magnitude(height[f]);
    const Mask low = (d < splat(kSeenFromFace * __builtin_sqrt(face.area2))) & (d < least) & widened(faces.is_near(f));
    if (!any(low)) [[likely]]
      continue;
    const SeenVertex* const corner[3] = {vertex + face.vertex[0], vertex + face.vertex[1], vertex + face.vertex[2]};
    const SeenHeights seen = seen_heights(face, corner, height[f]);
    const Mask here = low & (seen.h[0] > d) & (seen.h[1] > d) & (seen.h[2] > d);
    base = select(here, splat(f), base);
    least = select(here, d, least);
  }
  return base;
}

/// Weights in columns, without those of base faces, become coordinates with derivatives. \param base of the points
template <int O>
void normalise_from_faces(Block& block, const BaseFace& base) {
  auto* const columns = reinterpret_cast<Lanes*>(block.columns);
  const Columns& layout = block.layout;
  const auto at = [&](int v) {
    SpaceJet jet;
    jet.value = columns[layout.first[0][0] + v];
    for (int i = 0; i < 3; ++i) jet.gradient[i] = columns[layout.first[1][0] + 3 * v + i];
    if constexpr (O >= 2)
      for (int i = 0; i < 6; ++i) jet.hessian[i] = columns[layout.first[2][0] + 6 * v + i];
    return jet;
  };
  const auto add = [](SpaceJet& to, const SpaceJet& more, double sign, Mask where) {
    to.value += select(where, sign * more.value, Lanes{});
    for (int i = 0; i < 3; ++i) to.gradient[i] += select(where, sign * more.gradient[i], Lanes{});
    if constexpr (O >= 2)
      for (int i = 0; i < 6; ++i) to.hessian[i] += select(where, sign * more.hessian[i], Lanes{});
  };
  const Mask all = Mask{} == Mask{};
  SpaceJet others;
  for (int v = 0; v < block.cage->vertices; ++v) add(others, at(v), 1, all);
  // Without a base face there is no height to multiply with.
  SpaceJet height = base.height;
  height.value = select(base.seen, height.value, splat(1));
  SpaceJet whole = product_of<O>(height, others), corner[3];
  add(whole, base.total, 1, base.seen);
  for (int k = 0; k < 3; ++k) {
    corner[k] = base.rest[k];
    add(corner[k], product_of<O>(base.hat[k], others), -1, all);
  }
  const Lanes over = 1 / whole.value;
  Mask left = mask_of(block.left) | ~((over - over) == Lanes{});
  for (int i = 0; i < 3; ++i) left |= ~((whole.gradient[i] - whole.gradient[i]) == Lanes{});
  if constexpr (O >= 2)
    for (int i = 0; i < 6; ++i) left |= ~((whole.hessian[i] - whole.hessian[i]) == Lanes{});
  for (int v = 0; v < block.cage->vertices; ++v) {
    SpaceJet rest = at(v);
    Mask own[3];
    for (int k = 0; k < 3; ++k) {
      own[k] = base.seen & (base.vertex[k] == splat(v));
      if (any(own[k])) add(rest, corner[k], 1, own[k]);
    }
    const SpaceJet part = product_of<O>(height, rest);
    SpaceJet lambda;
    lambda.value = part.value / whole.value;
    for (int i = 0; i < 3; ++i) lambda.gradient[i] = (part.gradient[i] - lambda.value * whole.gradient[i]) * over;
    if constexpr (O >= 2)
      for (int i = 0; i < 6; ++i) {
        const int a = kHessianFirst[i], b = kHessianSecond[i];
        lambda.hessian[i] = (part.hessian[i] - lambda.value * whole.hessian[i] -
                             lambda.gradient[a] * whole.gradient[b] - lambda.gradient[b] * whole.gradient[a]) *
                            over;
      }
    for (int k = 0; k < 3; ++k)
      if (any(own[k])) add(lambda, base.hat[k], 1, own[k]);
    columns[layout.first[0][0] + v] = lambda.value;
    for (int i = 0; i < 3; ++i) columns[layout.first[1][0] + 3 * v + i] = lambda.gradient[i];
    if constexpr (O >= 2)
      for (int i = 0; i < 6; ++i) columns[layout.first[2][0] + 6 * v + i] = lambda.hessian[i];
  }
  block.left = bits_of(left);
}

}  // namespace cageproof::closed_form::batch::CAGEPROOF_SIMD
