// SPDX-License-Identifier: MIT
// One edge's part of the layers of a polygon, a vector of points at a time.
//
// With hat functions Gamma_k of the ends, A = int Gamma_0 dw/z = L/2 + S, B = L/2 - S, M and D the means of ln |z| and
// of tau ln |z| over the edge (tau from -1 to 1), h the height, n the outward normal, u the direction as a complex
// number:
//   2 pi phi^k = Im F_k,  F = (A, B),  2 pi psi = -length M,  8 pi phibar^k = -h q_k,  q_k = length (M -+ D - 1/2),
//   2 pi T^k = Im F_k Id + (1 - beta) Re F_k (n u' - u n') - beta h Mat(u conj F_k'),  Mat(c) = (Re c, Im c; Im c, -Re
//   c).
// Sources as of the closed forms of segments, of which this is the complex notation. F_k' has a part +-1/z_k at its end
// that sums to nothing with the next edge's. Where both are seen from afar each keeps its own, and the rest is small;
// elsewhere it is left out, since it grows without bound towards the vertex.
#pragma once

#include "plane_side.h"

namespace cageproof::closed_form::batch::CAGEPROOF_SIMD {

/// Sums over edges.
struct PlaneSums {
  Lanes* columns;
  const Columns* layout;
  Lanes* at(int order, int block, int coordinate, int kept) const {
    return columns + layout->first[order][block] + coordinate * kept;
  }
};

inline void add(Lanes* to, Lanes x) { *to += x; }
/// Adds (Re, -Im) of an analytic function's derivative, and its second: those of its real part.
inline void add_slope(Lanes* to, const Complex& d) {
  to[0] += d.re;
  to[1] -= d.im;
}
inline void add_bend(Lanes* to, const Complex& d) {
  to[0] += d.re;
  to[1] -= d.im;
  to[2] -= d.re;
}
/// -i d: the imaginary part of an analytic function f is the real part of -i f.
inline Complex turned(const Complex& d) { return {d.im, -d.re}; }

struct SeenEdgeOfPlane {
  const SideTable& side;
  const SeenEnd &a, &b;
  const SeenSide& seen;

  Complex hat(int k) const { return k == 0 ? 0.5 * seen.whole + seen.bend : 0.5 * seen.whole - seen.bend; }
  /// F_k' with all its parts.
  Complex hat_slope(int k, Mask afar, const Complex& over_middle) const {
    const Complex& over = k == 0 ? a.over : b.over;
    const Complex half = 0.5 * times(side.e, over);
    const Complex far = over_middle * (k == 0 ? half - seen.bend : half + seen.bend);
    const Complex near = k == 0 ? over - seen.mean : seen.mean - over;
    return select(afar, far, near);
  }
};

/// phi and psi.
template <int O>
void add_harmonic(const SeenEdgeOfPlane& edge, Mask afar, const Complex& over_middle, Lanes mean_log,
                  const PlaneSums& sums, int number) {
  const SideTable& side = edge.side;
  const SeenSide& seen = edge.seen;
  const SeenEnd* const end[2] = {&edge.a, &edge.b};
  const int vertex[2] = {side.from, side.to};
  const Complex product = O >= 2 ? edge.a.over * edge.b.over : Complex{};
  for (int k = 0; k < 2; ++k) {
    add(sums.at(0, 0, vertex[k], 1), edge.hat(k).im);
    if constexpr (O >= 1) {
      const Complex without = k == 0 ? -seen.mean : seen.mean;
      const Complex slope = select(end[k]->apart, edge.hat_slope(k, afar, over_middle), without);
      add_slope(sums.at(1, 0, vertex[k], 2), turned(slope));
    }
    if constexpr (O >= 2) {
      const Complex far = product * times(side.e, end[k]->over), without = k == 0 ? -product : product;
      add_bend(sums.at(2, 0, vertex[k], 3), turned(select(end[k]->apart, far, without)));
    }
  }
  add(sums.at(0, 1, number, 1), -side.length * mean_log);
  if constexpr (O >= 1) add_slope(sums.at(1, 1, number, 2), side.length * seen.mean);
  if constexpr (O >= 2) add_bend(sums.at(2, 1, number, 3), side.length * product);
}

/// The integral of z z'/|z|^2 is (length Id + Mat(p))/2, with this p.
inline Complex direction_moment(const SeenEdgeOfPlane& edge) {
  const SideTable& side = edge.side;
  const Complex& whole = edge.seen.whole;
  const Lanes twice = 2 * edge.seen.height;
  return times(side.u, times(side.u, {side.length + twice * whole.im, twice * whole.re}));
}

/// phibar and psibar.
template <int O>
void add_biharmonic(const SeenEdgeOfPlane& edge, Mask afar, const Complex& over_middle, Lanes mean_log,
                    const PlaneSums& sums, int number) {
  const SideTable& side = edge.side;
  const SeenSide& seen = edge.seen;
  const Complex& middle = seen.middle;
  const int vertex[2] = {side.from, side.to};
  const double n[2] = {side.u[1], -side.u[0]};
  const Lanes h = seen.height;
  const Lanes tilt = 0.25 * seen.whole.re - 0.5 * seen.half_over.re;  // D
  for (int k = 0; k < 2; ++k) {
    const Lanes q = side.length * (mean_log + (k == 0 ? -tilt : tilt) - 0.5);
    add(sums.at(0, 2, vertex[k], 1), -(h * q));
    if constexpr (O >= 1) {
      const Complex slope = -2 * times_conjugate(side.u, edge.hat(k));  // (Re, -Im) is grad q
      Lanes* const gradient = sums.at(1, 2, vertex[k], 2);
      gradient[0] -= q * n[0] + h * slope.re;
      gradient[1] -= q * n[1] - h * slope.im;
      if constexpr (O >= 2) {
        const Complex bend = -2 * times_conjugate(side.u, edge.hat_slope(k, afar, over_middle));
        Lanes* const hessian = sums.at(2, 2, vertex[k], 3);
        hessian[0] -= 2 * n[0] * slope.re + h * bend.re;
        hessian[1] -= n[1] * slope.re - n[0] * slope.im - h * bend.im;
        hessian[2] += 2 * n[1] * slope.im + h * bend.re;
      }
    }
  }
  const Lanes along = middle.re * side.u[0] + middle.im * side.u[1];
  const Lanes end_log = 0.5 * (edge.a.log + edge.b.log);
  const Lanes second = (end_log + seen.bend_over.re - 1 / 3.) * (1 / 3.);  // the mean of tau^2 ln |z|
  const double twelfth = side.square / 12;
  *sums.at(0, 3, number, 1) -=
      side.length * (squared(middle) * (mean_log - 1) + side.length * along * tilt + 3 * twelfth * second - twelfth);
  if constexpr (O >= 1) {
    Lanes* const gradient = sums.at(1, 3, number, 2);
    const Lanes weight = 2 * mean_log - 1;
    gradient[0] += side.length * (middle.re * weight + side.e[0] * tilt);
    gradient[1] += side.length * (middle.im * weight + side.e[1] * tilt);
  }
  if constexpr (O >= 2) {
    Lanes* const hessian = sums.at(2, 3, number, 3);
    const Complex p = direction_moment(edge);
    const Lanes round = 2 * side.length * mean_log;
    hessian[0] -= round + p.re;
    hessian[1] -= p.im;
    hessian[2] -= round - p.re;
  }
}

}  // namespace cageproof::closed_form::batch::CAGEPROOF_SIMD
