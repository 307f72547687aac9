// SPDX-License-Identifier: MIT
// A triangle in polar coordinates about its point nearest to eta.
//
// eta is the point, c the triangle's point nearest to it, and p_k are the corners. The triangle is the disjoint union
// of the triangles (c, p_k, p_{k+1}) over the edges that do not contain c. In each, with v = v0 + t:
//   direction e = (nu + u sinh v)/cosh v, radius 0 <= tau <= a cosh v, x = (c - eta) + tau e,
//   dA = tau dtau dt/cosh v.
// As (c - eta).e >= 0, r^2 = tau^2 + 2 tau (c - eta).e + distance^2 has no cancellation.
#pragma once

#include "../elementary.h"
#include "../panels.h"
#include "triangle_frame.h"

namespace cageproof::quadrature_ref {

/// An edge as seen from c.
template <Scalar R>
struct PolarEdge {
  Vec3<R> nu, u;           ///< in-plane unit normal away from c, unit direction
  R a;                     ///< distance from c to the edge's line, > 0
  R v0, v_length;          ///< v = asinh(s/a) at the start and its growth to the end, s the arc length from c's foot
  int start;               ///< the corner at t = 0
  R relative_height;       ///< 2 a / length: hat functions at the edge are 1 - f, f, 0 from the start corner on,
                           ///< f = relative_height cosh(v0 + t/2) sinh(t/2)
  Singularities singular;  ///< of the integrand as a function of t = v - v0
};

template <Scalar R>
struct PolarFrame {
  Vec3<R> base;                                ///< c - eta
  Vec3<R> normal;                              ///< unit, outward
  R height;                                    ///< x . normal of every x on the triangle
  R distance;                                  ///< |base|, > 0
  std::array<R, 3> hat;                        ///< hat functions at c
  Vec3<R> along, across;                       ///< in-plane unit vectors, for rings around c
  std::array<R, 3> slope_along, slope_across;  ///< derivative of each hat function along them
  boost::container::static_vector<PolarEdge<R>, 3> edges;
  bool interior = false;  ///< c is off all edges: a disc around it lies in the triangle, and r is constant on circles
  int exponent = 0;       ///< lengths are in units of 2^exponent
};

/// An edge's line: direction, in-plane outward normal, the edge's length, signed in-plane distance of eta's projection
/// (> 0 inside), and where along u the edge starts and ends, seen from eta.
struct EdgeLine {
  Vec3<Mp200> u, nu;
  Mp200 length, inside, start, end;
};

/// A triangle's frame with the lines of its edges.
struct LinedTriangle : TriangleFrame<Mp200> {
  std::array<EdgeLine, 3> lines;
};

/// The triangle; nothing if it has no area or the input is not finite.
std::optional<LinedTriangle> lined_triangle(std::span<const Vec3<Mp200>> corners, const Vec3<Mp200>& point);

/// Whether a point is exactly on the triangle, and where.
struct OnTriangle {
  bool yes = false;
  bool border = false;  ///< on an edge or a corner
  Mp200 clearance = 0;  ///< smallest distance above zero to a corner or an edge's line
};

OnTriangle on_triangle(const LinedTriangle& t);

/// The frame of a point off the triangle, or of one on it after moving it by `inward` > 0 along minus the normal.
PolarFrame<Mp200> polar_frame(const LinedTriangle& t, const Mp200& inward);

template <Scalar To>
PolarFrame<To> convert(const PolarFrame<Mp200>& from) {
  PolarFrame<To> to;
  to.base = cageproof::convert<To>(from.base);
  to.normal = cageproof::convert<To>(from.normal);
  to.height = static_cast<To>(from.height);
  to.distance = static_cast<To>(from.distance);
  to.along = cageproof::convert<To>(from.along);
  to.across = cageproof::convert<To>(from.across);
  for (int k = 0; k < 3; ++k) {
    to.hat[k] = static_cast<To>(from.hat[k]);
    to.slope_along[k] = static_cast<To>(from.slope_along[k]);
    to.slope_across[k] = static_cast<To>(from.slope_across[k]);
  }
  to.interior = from.interior;
  to.exponent = from.exponent;
  for (const PolarEdge<Mp200>& edge : from.edges) {
    PolarEdge<To>& e = to.edges.emplace_back();
    e.nu = cageproof::convert<To>(edge.nu);
    e.u = cageproof::convert<To>(edge.u);
    e.a = static_cast<To>(edge.a);
    e.v0 = static_cast<To>(edge.v0);
    e.v_length = static_cast<To>(edge.v_length);
    e.start = edge.start;
    e.relative_height = static_cast<To>(edge.relative_height);
    e.singular = edge.singular;
  }
  return to;
}

}  // namespace cageproof::quadrature_ref
