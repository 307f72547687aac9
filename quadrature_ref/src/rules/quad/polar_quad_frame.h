// SPDX-License-Identifier: MIT
// A bilinear quad cut into the triangles (c, corner, next corner) of its parameter domain.
//
// In each, (u, v) = c + rho d(t), 0 <= rho <= 1, with d(t) + c on a side of the square: along it one of u and v is
// constant, so that xi - eta = X + rho D(t) + rho^2 d_u d_v W with D = A d_u + B d_v is linear in t and quadratic in
// rho: both its zeros as a function of t and as a function of rho can be computed, and with them how fast rules
// converge. Variables: t - t* = eps sinh tau, t* where D is shortest; rho = delta sinh w.
#pragma once

#include "../elementary.h"
#include "closest_point.h"

namespace cageproof::quadrature_ref {

template <Scalar R>
struct QuadSector {
  R du, dv;           ///< d at the foot t*
  R step_u, step_v;   ///< d' : one of them 0, the other 1 or -1
  Vec3<R> to_edge;    ///< D at the foot
  Vec3<R> edge;       ///< D'
  R eps;              ///< |D| at the foot in units of D'
  R tau, tau_length;  ///< tau at the edge's start and its growth to the end
  R jacobian;         ///< d x d': du dv = jacobian rho drho dt
};

template <Scalar R>
struct PolarQuadFrame {
  QuadExpansion<R> at;  ///< about c
  R distance;           ///< |X|
  int exponent = 0;     ///< lengths are in units of 2^exponent
  std::vector<QuadSector<R>> sectors;
};

/// The frame about a parameter in the square. \pre it is not at eta
PolarQuadFrame<Mp200> polar_quad_frame(const QuadFrame<Mp200>& q, const Mp200& u, const Mp200& v);

template <Scalar To>
PolarQuadFrame<To> convert(const PolarQuadFrame<Mp200>& from) {
  using cageproof::convert;
  PolarQuadFrame<To> to{
      cageproof::quadrature_ref::convert<To>(from.at), static_cast<To>(from.distance), from.exponent, {}};
  const auto number = [](const Mp200& x) { return static_cast<To>(x); };
  for (const QuadSector<Mp200>& s : from.sectors)
    to.sectors.push_back({number(s.du), number(s.dv), number(s.step_u), number(s.step_v), convert<To>(s.to_edge),
                          convert<To>(s.edge), number(s.eps), number(s.tau), number(s.tau_length), number(s.jacobian)});
  return to;
}

}  // namespace cageproof::quadrature_ref
