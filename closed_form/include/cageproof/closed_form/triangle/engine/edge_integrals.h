// SPDX-License-Identifier: MIT
// Integrals of powers of the distance over an edge, in the forms without cancellation, and their Taylor polynomials.
#pragma once

#include "cageproof/closed_form/arithmetic/taylor.h"
#include "cageproof/closed_form/triangle/engine/frame.h"

namespace cageproof::closed_form::triangle {

/// True when the point lies on the edge itself, or so close to its end that the distance underflows: there the
/// integrals of 1/r and of steeper powers diverge.
template <class R>
bool on_edge(const FrameEdge<R>& e) {
  return e.D2 == R(0) && ((!(e.s0 > R(0)) && !(e.s1 < R(0))) || e.r0 == R(0) || e.r1 == R(0));
}

/// atanh(z)/z - 1 to double's full relative accuracy, 0 <= z <= 1/2: the Taylor series, whose 26th term is below the
/// rounding of the first.
template <class R>
R atanh_excess_by_series(const R& z) {
  const R q = z * z;
  R sum = 0;
  for (int k = 26; k >= 1; --k) sum = q * (R(1) / R(2 * k + 1) + sum);
  return sum;
}

/// atanh(z)/z - 1, as accurate as atanh is, absolutely.
template <class R>
R atanh_excess_by_function(const R& z) {
  using std::atanh;
  return z == R(0) ? R(0) : R(atanh(z) / z - R(1));
}

/// atanh(z)/z - 1 to full relative accuracy in float and double, 0 <= z <= 1/2.
template <class R>
R atanh_excess(const R& z) {
  if constexpr (Scalar<R> && !is_multiprecision<R>) return atanh_excess_by_series(z);
  else return atanh_excess_by_function(z);
}

/// The values of the integrals over one edge of odd powers of r. K3, K5 and K7 are found by t = s/r; K7, for example,
/// is D2^-3 int (1 - t^2)^2 dt, whose mean over the span is a sum of squares.
///
/// Sums of 1/r and r over a triangle's edges, weighted with the normals, lose the part that the edges share, since the
/// normals times the lengths add up to zero. So `_rest` leaves out the part of a distance `reference`, the same for all
/// edges.
template <class R>
struct OddIntegrals {
  R L;                    ///< 1/r, which diverges on the edge itself
  R L_rest;               ///< 1/r - 1/reference
  R P;                    ///< r
  R P_rest;               ///< r - reference
  R K3, K5, K7;           ///< r^-3, r^-5, r^-7
  std::array<R, 4> ends;  ///< r1^p - r0^p for p = 1, -1, -3, -5

  /// \param border_log the value of L on the edge itself, where the integral diverges
  OddIntegrals(const Frame<R>& f, int i, const R& border_log) {
    using std::log;
    const FrameEdge<R>& e = f.edges[i];
    const R sum = e.r0 + e.r1;
    const R mean = sum / R(2);
    const R difference = e.length * (e.s0 + e.s1) / sum;  // r1 - r0
    const R& reference = f.farthest();
    const R mean_rest = (f.distance_rest(i) + f.distance_rest((i + 1) % 3)) / R(2);
    const R product = e.r0 * e.r1;
    const bool spans = e.s0 < R(0) && e.s1 > R(0);
    const R z = e.length / sum;
    if (R(2) * e.length < sum) {
      const R excess = atanh_excess(z);
      L = (e.length / mean) * (R(1) + excess);
      L_rest = (e.length / mean) * (excess - mean_rest / reference);
      // The mean of r over an edge is the mean of r at its ends less this term, in the coordinates of the ellipse whose
      // foci are the corners.
      P_rest = e.length * mean_rest - e.D2 * (e.length / mean) * (z * z / (R(1) - z * z) - excess) / R(2);
      P = P_rest + e.length * reference;
    } else {
      if (on_edge(e)) L = border_log;
      else if (spans) L = log((e.r1 + e.s1) * ((e.r0 - e.s0) / e.D2));
      // r0 + r1 - length without cancellation, for a point next to a corner.
      else if (e.s0 >= R(0)) L = log((sum + e.length) / (e.r0 + e.s0 + e.D2 / (e.r1 + e.s1)));
      else L = log((sum + e.length) / (e.r1 - e.s1 + e.D2 / (e.r0 - e.s0)));
      L_rest = L - e.length / reference;
      P = (e.D2 * L + e.length * (sum + (e.s0 + e.s1) * (e.s0 + e.s1) / sum) / R(2)) / R(2);
      P_rest = P - e.length * reference;
    }
    if (spans) K3 = (e.s1 / e.r1 - e.s0 / e.r0) / e.D2;
    else K3 = e.length * (e.s0 + e.s1) / (product * (e.s1 * e.r0 + e.s0 * e.r1));
    const R q0 = R(1) / (e.r0 * e.r0), q1 = R(1) / (e.r1 * e.r1);
    const R Q = (q0 + q1) / R(2), k = K3 * K3 * e.D2, slope = difference * sum * q0 * q1;  // q0 - q1
    K5 = K3 * (Q + k / R(6));
    K7 = K3 * (Q * Q + Q * k / R(3) + k * k / R(30) + slope * slope / R(12));
    ends[0] = difference;
    ends[1] = -difference / product;
    ends[2] = ends[1] * (q0 + R(1) / product + q1);
    ends[3] = ends[1] * (q0 * q0 + q1 * q1 + (q0 + q1) / product + q0 * q1);
    // On the border these are multiplied by zero, or enter orders that have no limit.
    if (on_edge(e)) K3 = K5 = K7 = R(0);
    if (product == R(0)) ends[1] = ends[2] = ends[3] = R(0);
  }
};

/// The integral of r^p over an edge up to degree N, from that of r^(p-2) (`inner`) and the end values r1^p - r0^p
/// (`ends`). With the vector D from the point to the nearest point of the line (D2 = |D|^2), grad int r^p = -(r1^p -
/// r0^p) u - p D int r^(p-2), and k f_k = delta . (grad f)_{k-1}.
template <int N, class R, int E, int I>
Taylor<R, N> edge_power(const FrameEdge<R>& e, const Vec3<R>& n, const R& d, int p, const R& value,
                        const Taylor<R, E>& ends, const Taylor<R, I>& inner) {
  using M = Monomials<N>;
  Taylor<R, N> f;
  f.c[0] = value;
  const std::array<const Vec3<R>*, 2> across{&e.nu, &n};
  const std::array<R, 2> offset{e.h, -d};
  for (int k = 1; k <= N; ++k) {
    Taylor<R, N> part;
    for (int m = M::first(k - 1); m < M::first(k); ++m) part.c[m] = -ends.c[m];
    f.add_raised(k, e.u, part);
    for (int b = 0; b < 2; ++b) {
      Taylor<R, N> weighted;
      if (k >= 2) weighted.add_raised(k - 1, *across[b], inner);
      for (int m = M::first(k - 1); m < M::first(k); ++m) part.c[m] = R(-p) * (offset[b] * inner.c[m] - weighted.c[m]);
      f.add_raised(k, *across[b], part);
    }
    f.divide_part(k, R(k));
  }
  return f;
}

}  // namespace cageproof::closed_form::triangle
