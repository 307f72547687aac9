// SPDX-License-Identifier: MIT
// Integrals of powers of the distance over an edge, in the forms without cancellation.
#pragma once

#include "cageproof/closed_form/jet.h"
#include "cageproof/closed_form/triangle/frame.h"

namespace cageproof::closed_form {

/// True when the point lies on the edge itself, or so close to its end that the distance underflows: there the integrals of 1/r and
/// beyond diverge.
template <Scalar R>
bool on_edge(const FrameEdge<R>& e) {
  return e.D2 == 0 && ((!(e.s0 > 0) && !(e.s1 < 0)) || e.r0 == 0 || e.r1 == 0);
}

/// atanh(z)/z - 1 to full relative accuracy, 0 <= z <= 1/2.
template <Scalar R>
R atanh_excess(const R& z) {
  if constexpr (is_multiprecision<R>) {
    using std::atanh;
    return z == 0 ? R(0) : R(atanh(z) / z - 1);
  } else {
    // The Taylor series: its 26th term is below the rounding of the first.
    const R q = z * z;
    R sum = 0;
    for (int k = 26; k >= 1; --k) sum = q * (R(1) / R(2 * k + 1) + sum);
    return sum;
  }
}

/// Integrals over one edge of odd powers of r (edge form, table of per-edge integrals).
///
/// Sums over a triangle's edges of 1/r and r, weighted with the normals, lose what the edges have in common, since the normals times the
/// lengths add up to nothing. So the part of a distance `reference`, shared by all edges, is left out from the start.
template <Scalar R>
struct OddIntegrals {
  R L;         ///< 1/r; zero on the edge itself, where only its products with vanishing factors count
  R L_rest;    ///< 1/r - 1/reference
  R P_rest;    ///< r - reference
  R along_rest, across_rest;  ///< x/r less its value at the reference corner: the parts along u and nu
  R K3, S3;    ///< 1/r^3 and s/r^3
  R K5, S5;    ///< 1/r^5 and s/r^5
  R SS3, SS5;  ///< s^2/r^3 and s^2/r^5

  OddIntegrals(const Frame<R>& f, int i) {
    using std::log;
    const FrameEdge<R>& e = f.edges[i];
    const R sum = e.r0 + e.r1;
    const R mean = sum / 2;
    const R difference = e.length * (e.s0 + e.s1) / sum;  // r1 - r0
    const R& reference = f.farthest();
    const R mean_rest = (f.distance_rest(i) + f.distance_rest((i + 1) % 3)) / 2;
    const R product = e.r0 * e.r1;
    const bool spans = e.s0 < 0 && e.s1 > 0;
    const R z = e.length / sum;
    if (2 * e.length < sum) {
      const R excess = atanh_excess(z);
      L = (e.length / mean) * (1 + excess);
      L_rest = (e.length / mean) * (excess - mean_rest / reference);
      // The mean of r over an edge is the mean of its ends less this, in the ellipse's coordinates with the corners as foci.
      P_rest = e.length * mean_rest - e.D2 * (e.length / mean) * (z * z / (1 - z * z) - excess) / 2;
    } else {
      if (on_edge(e)) L = R(0);
      else if (spans) L = log((e.r1 + e.s1) * ((e.r0 - e.s0) / e.D2));
      // r0 + r1 - length without cancellation, for a point next to a corner.
      else if (e.s0 >= 0) L = log((sum + e.length) / (e.r0 + e.s0 + e.D2 / (e.r1 + e.s1)));
      else L = log((sum + e.length) / (e.r1 - e.s1 + e.D2 / (e.r0 - e.s0)));
      L_rest = L - e.length / reference;
      P_rest = (e.D2 * L + e.length * (sum + (e.s0 + e.s1) * (e.s0 + e.s1) / sum) / 2) / 2 - e.length * reference;
    }
    along_rest = (e.length / mean) * (f.midpoint_rest(i) - e.u.dot(f.p[f.far_corner]) * mean_rest / reference);
    across_rest = L_rest * e.h + (f.far_corner == (i + 2) % 3 ? R(f.area2 / reference) : R(0));
    if (spans) K3 = (e.s1 / e.r1 - e.s0 / e.r0) / e.D2;
    else K3 = e.length * (e.s0 + e.s1) / (product * (e.s1 * e.r0 + e.s0 * e.r1));
    S3 = difference / product;
    const R q0 = 1 / (e.r0 * e.r0), q1 = 1 / (e.r1 * e.r1);
    K5 = K3 * ((q0 + q1) / 2 + K3 * K3 * e.D2 / 6);
    S5 = difference * (q0 + 1 / product + q1) / (3 * product);
    SS3 = L - e.D2 * K3;
    SS5 = K3 - e.D2 * K5;
  }
};

/// Gradient of P_rest: what all edges share is length x/r at the reference corner.
template <Scalar R>
Vec3<R> gradient_P_rest(const Frame<R>& f, int i, const OddIntegrals<R>& o) {
  const FrameEdge<R>& e = f.edges[i];
  return f.d * o.L_rest * f.n - o.along_rest * e.u - o.across_rest * e.nu;
}

/// Gradient of the integral of 1/r over an edge.
template <Scalar R>
Vec3<R> gradient_L(const FrameEdge<R>& e, const OddIntegrals<R>& o) {
  return o.S3 * e.u + o.K3 * e.D;
}

/// Gradient of the integral of 1/r^3 over an edge.
template <Scalar R>
Vec3<R> gradient_K3(const FrameEdge<R>& e, const OddIntegrals<R>& o) {
  return 3 * (o.S5 * e.u + o.K5 * e.D);
}

/// Hessian of the integral of r over an edge.
template <Scalar R>
Mat3<R> hessian_P(const FrameEdge<R>& e, const OddIntegrals<R>& o) {
  return o.L * Mat3<R>::Identity() - o.SS3 * e.u * e.u.transpose() - o.S3 * symmetric_outer<R>(e.u, e.D) -
         o.K3 * e.D * e.D.transpose();
}

/// Hessian of the integral of 1/r over an edge.
template <Scalar R>
Mat3<R> hessian_L(const FrameEdge<R>& e, const OddIntegrals<R>& o) {
  return -o.K3 * Mat3<R>::Identity() + 3 * o.SS5 * e.u * e.u.transpose() + 3 * o.S5 * symmetric_outer<R>(e.u, e.D) +
         3 * o.K5 * e.D * e.D.transpose();
}

}  // namespace cageproof::closed_form
