// SPDX-License-Identifier: MIT
// One edge of a polygon seen from a vector of points, as complex numbers.
//
// With z = w - x from the point to the places w of the edge E, z0 and z1 its ends, zm its middle and t = E/(2 zm), all
// that is integrated is made of
//   L = int dw/z = log(z1/z0) = 2 t (1 + S),   S = zm L/E - 1,   S2 = S/t^2,
// and of the logarithms at the ends. From afar (|t| < 1/8) they are sums of powers of t, which cancel nothing; next to
// the edge L is a logarithm and an angle, and S a difference that loses at most a factor of eight.
#pragma once

#include "cageproof/closed_form/batch/lanes.h"

#include "plane_tables.h"

namespace cageproof::closed_form::batch::CAGEPROOF_SIMD {

/// Distances from vertices below this are left to others: their squares' squares leave double's range.
inline constexpr double kLeastSquare = 0x1p-800;

inline unsigned bits_of_lanes(Mask m) {
  unsigned bits = 0;
  for (int i = 0; i < kLanes; ++i) bits |= (m[i] != 0 ? 1u : 0u) << i;
  return bits;
}

/// One complex number per point.
struct Complex {
  Lanes re{}, im{};
};

inline Complex operator+(const Complex& a, const Complex& b) { return {a.re + b.re, a.im + b.im}; }
inline Complex operator-(const Complex& a, const Complex& b) { return {a.re - b.re, a.im - b.im}; }
inline Complex operator-(const Complex& a) { return {-a.re, -a.im}; }
inline Complex operator*(const Complex& a, const Complex& b) {
  return {a.re * b.re - a.im * b.im, a.re * b.im + a.im * b.re};
}
inline Complex operator*(Lanes x, const Complex& a) { return {x * a.re, x * a.im}; }
inline Complex operator*(double x, const Complex& a) { return {x * a.re, x * a.im}; }
/// Times a constant, or its conjugate.
inline Complex times(const double (&c)[2], const Complex& a) {
  return {c[0] * a.re - c[1] * a.im, c[0] * a.im + c[1] * a.re};
}
inline Complex times_conjugate(const double (&c)[2], const Complex& a) {
  return {c[0] * a.re + c[1] * a.im, c[0] * a.im - c[1] * a.re};
}
inline Complex conjugate(const Complex& a) { return {a.re, -a.im}; }
inline Complex select(Mask m, const Complex& a, const Complex& b) {
  return {select(m, a.re, b.re), select(m, a.im, b.im)};
}
inline Lanes squared(const Complex& a) { return a.re * a.re + a.im * a.im; }
inline Complex inverse(const Complex& a) {
  const Lanes over = 1 / squared(a);
  return {a.re * over, -a.im * over};
}

/// A vertex seen from the points.
struct SeenEnd {
  Complex z, over;  ///< over: 1/z
  Lanes square;     ///< |z|^2
  Lanes log;        ///< ln |z| in the caller's unit
  Mask apart;       ///< whether all edges at the vertex are seen from afar
};

/// An edge seen from the points.
struct SeenSide {
  Complex middle;       ///< zm
  Complex whole;        ///< L
  Complex bend;         ///< S
  Complex bend_over;    ///< S2
  Complex mean;         ///< L/E
  Complex half_over;    ///< S/t
  Lanes height;         ///< signed distance from the line, positive outside
  Lanes across, along;  ///< vector and scalar product of z0 and z1
};

/// The middle of an edge is further away than four times its length.
inline Mask is_afar(const SideTable& side, const Complex& middle) { return squared(middle) > 16 * side.square; }

inline Complex middle_of(const SeenEnd& a, const SeenEnd& b) { return 0.5 * (a.z + b.z); }

/// Heights and products by the nearer end, whose differences are the more exact.
inline void see_across(const SideTable& side, const SeenEnd& a, const SeenEnd& b, SeenSide& seen) {
  const Complex near = select(less(a.square, b.square), a.z, b.z);
  seen.across = near.re * side.e[1] - near.im * side.e[0];
  seen.along = a.z.re * b.z.re + a.z.im * b.z.im;
  seen.height = -seen.across / side.length;
}

inline void see_from_afar(const SideTable& side, SeenSide& seen) {
  const Complex over = inverse(seen.middle);
  const Complex t = 0.5 * times(side.e, over), q = t * t;
  Complex sum{splat(1 / 19.), Lanes{}};
  for (int odd = 17; odd >= 3; odd -= 2) {
    sum = q * sum;
    sum.re += 1. / odd;
  }
  seen.bend_over = sum;
  seen.bend = q * sum;
  seen.half_over = t * sum;
  Complex one = seen.bend;
  one.re += 1;
  seen.whole = 2 * (t * one);
  seen.mean = over * one;
}

/// log(b.square/a.square), without loss where they are alike.
inline Lanes log_ratio(const SideTable& side, const SeenEnd& a, const SeenEnd& b, const Complex& middle) {
  const Lanes difference = 2 * (middle.re * side.e[0] + middle.im * side.e[1]);
  const Lanes sum = a.square + b.square;
  return log_of_quotient(b.square, a.square, difference, sum, 5 * magnitude(difference) < sum);
}

inline void see_from_nearby(const SideTable& side, const SeenEnd& a, const SeenEnd& b, Lanes angle, SeenSide& seen) {
  seen.whole = {0.5 * log_ratio(side, a, b, seen.middle), angle};
  seen.mean = times(side.over, seen.whole);
  seen.bend = seen.middle * seen.mean;
  seen.bend.re -= 1;
  const Complex twice = times(side.over, 2 * seen.middle);
  seen.half_over = twice * seen.bend;
  seen.bend_over = twice * seen.half_over;
}

inline SeenSide select(Mask m, const SeenSide& a, const SeenSide& b) {
  SeenSide s = a;
  s.whole = select(m, a.whole, b.whole);
  s.bend = select(m, a.bend, b.bend);
  s.bend_over = select(m, a.bend_over, b.bend_over);
  s.mean = select(m, a.mean, b.mean);
  s.half_over = select(m, a.half_over, b.half_over);
  return s;
}

/// Next to an edge, rounding may decide the sign of `across`, which tells a point's side, so it is decided exactly.
/// Points on the edge are treated as points just inside, whose limits they have.
inline void decide_sides(const PlaneBlock& block, const SideTable& side, SeenSide& seen) {
  const Mask next_to = (seen.along < Lanes{}) & (magnitude(seen.across) < -0x1p-46 * seen.along);
  if (!any(next_to)) [[likely]]
    return;
  for (int i = 0; i < kLanes; ++i) {
    if (next_to[i] == 0) continue;
    const double point[2] = {block.points[i], block.points[kLanes + i]};
    const int right = block.side_of(block.cage->vertex + 2 * side.from, block.cage->vertex + 2 * side.to, point);
    if (right == 0) seen.height[i] = 0;
    // A size below a multiple of the rounding of `along` becomes that multiple: negligible, and safe to divide by.
    double size = __builtin_fabs(seen.across[i]);
    const double least = -0x1p-60 * seen.along[i];
    if (size < least) size = least;
    seen.across[i] = right > 0 ? -size : size;
  }
}

}  // namespace cageproof::closed_form::batch::CAGEPROOF_SIMD
