// SPDX-License-Identifier: MIT
// Mean value coordinates seen from the edge that a point is next to, a vector of points at a time, as base_face.h does
// in space: h t is smooth, t = tan(angle/2) of that edge and h the height over it, and lambda = b + h (w - b W)/(h W),
// where b are the shares of the foot on the edge and w - b W of the edge itself has its h^2 by algebra:
//   h t = T = (|a||b| - a.b)/L,   h V = T (1/|a| + 1/|b|),
//   h (w_a - b_a V) = h^2 T (s - s')/(|a||b| (s |b| + s' |a|)),   s, s' from a and b to the foot.
#pragma once

#include "plane_jet.h"

namespace cageproof::closed_form::batch::CAGEPROOF_SIMD {

/// Heights over an edge's length below which points are seen from it.
inline constexpr double kSeenFromSide = 0x1p-3;
/// Heights, over the length, that may be roundings, so that the point may be on the edge.
inline constexpr double kLostOverSide = 0x1p-44;
/// Distances from an edge's ends, over its length, below which derivatives of that order are left to others.
inline constexpr double kLeftAtEnds[3] = {0, 0x1p-9, 0x1p-7};

/// The edge that each point is seen from, in the point's terms; zero for points without one.
struct BaseSide {
  Mask seen{};
  Lanes vertex[2] = {splat(-1), splat(-1)};
  PlaneJet height;  ///< h, inward
  PlaneJet share;   ///< b of the first end
  PlaneJet rest;    ///< h (w - b V) of the first end, of the second its negative
  PlaneJet total;   ///< h V
};

/// Whether the points are next to the edge within, and nearer than to others before. \param least heights so far
inline Mask is_base(const SideTable& side, const SeenEnd& a, const SeenEnd& b, Lanes& least) {
  SeenSide seen;
  see_across(side, a, b, seen);
  const Lanes height = magnitude(seen.height);
  const Lanes before = -(a.z.re * side.u[0] + a.z.im * side.u[1]), behind = b.z.re * side.u[0] + b.z.im * side.u[1];
  const Mask base = (height < kSeenFromSide * side.length) & (height < before) & (height < behind) & (height < least);
  least = select(base, height, least);
  return base;
}

/// |z| of an end as a function of the point.
template <int O>
PlaneJet distance_jet(const SeenEnd& end, Lanes distance) {
  PlaneJet r;
  r.value = distance;
  const Lanes away[2] = {-end.z.re / distance, -end.z.im / distance};
  if constexpr (O >= 1)
    for (int i = 0; i < 2; ++i) r.gradient[i] = away[i];
  if constexpr (O >= 2) {
    for (int at = 0; at < 3; ++at) r.hessian[at] = -away[kFirst[at]] * away[kSecond[at]] / distance;
    r.hessian[0] += 1 / distance;
    r.hessian[2] += 1 / distance;
  }
  return r;
}

/// Keeps an edge as that which some points are seen from.
template <int O>
void keep_side(const SideTable& side, const SeenEnd& a, const SeenEnd& b, Mask mine, BaseSide& base) {
  SeenSide seen;
  see_across(side, a, b, seen);
  const double *const u = side.u, over = 1 / side.length;
  const PlaneJet height = linear_jet(-seen.height, -u[1], u[0]);
  const PlaneJet s = linear_jet(-(a.z.re * u[0] + a.z.im * u[1]), u[0], u[1]);
  const PlaneJet behind = linear_jet(b.z.re * u[0] + b.z.im * u[1], -u[0], -u[1]);
  const PlaneJet ra = distance_jet<O>(a, a.log), rb = distance_jet<O>(b, b.log), both = product_of<O>(ra, rb);
  const PlaneJet squared_height = product_of<O>(height, height);
  // a.b is the square of the height less s s'.
  const PlaneJet tangent =
      scaled_jet<O>(sum_of<O>(sum_of<O>(both, product_of<O>(s, behind)), scaled_jet<O>(squared_height, -1)), over);
  const PlaneJet over_both = inverse_of<O>(both);
  const PlaneJet apart = inverse_of<O>(sum_of<O>(product_of<O>(s, rb), product_of<O>(behind, ra)));
  const PlaneJet turned = product_of<O>(tangent, over_both);
  base.seen |= mine;
  const int number[2] = {side.from, side.to};
  for (int k = 0; k < 2; ++k) base.vertex[k] = select(mine, splat(number[k]), base.vertex[k]);
  take<O>(mine, height, base.height);
  take<O>(mine, scaled_jet<O>(behind, over), base.share);
  take<O>(mine, product_of<O>(turned, sum_of<O>(ra, rb)), base.total);
  const PlaneJet lean = product_of<O>(sum_of<O>(s, scaled_jet<O>(behind, -1)), apart);
  take<O>(mine, product_of<O>(product_of<O>(turned, squared_height), lean), base.rest);
}

}  // namespace cageproof::closed_form::batch::CAGEPROOF_SIMD
