// SPDX-License-Identifier: MIT
// Integrals of 1/r and of powers of t over r^3 along lines, for one instruction set: elementary, with one logarithm.
//
// With the ends' distances r0 and r1, their sum s, a length l, y = l/s, q = m y^2 for the middle's place m from the
// foot of the perpendicular, L = 2 atanh y and K = 2 y/(r0 r1 (1 - y^2)), the moments about the middle are
//   int 1/r = L,  int w/r = -m (L - 2 y),  int 1/r^3 = K,  int w/r^3 = -q K,  int w^2/r^3 = (L - 2 y) + q^2 K,
// of terms of one sign. From s^2 - (r1 - r0)^2 = 4 r0 r1 and r1 - r0 = 2 m y. With the squared height
// h = (1 - y^2)(s^2/4 - m^2) of the point over the line and c = h (L - 2 y)/2,
//   int r = m^2 y + l s/4 + h L/2,  int w r = m (l^2 y/4 - m^2 y^3/3 - c),
//   int w^2/r = l^2 y/4 - m^2 y^3 + m^2 (L - 2 y) - c,
// whose terms are no larger than a few of the sums, however far the line is.
#pragma once

#include "../space_lanes.h"

#if defined(__AVX512F__)
#include <immintrin.h>
#endif

namespace cageproof::adaptive_qmvc::batch::CAGEPROOF_SIMD {

/// One over the root of a normal number, to about a rounding.
inline Lanes reciprocal_root(const Lanes& a) {
#if defined(__AVX512F__)
  // Fourteen bits, and three terms of the binomial series of what is left: its fourth is below a rounding.
  // With all lanes masked in: GCC takes the plain form's unused source for an uninitialised one.
  const Lanes guess = (Lanes)_mm512_maskz_rsqrt14_pd(0xff, (__m512d)a);
  const Lanes left = 1 - (a * guess) * guess;
  return guess + guess * (left * (0.5 + left * (0.375 + left * 0.3125)));
#else
  return 1 / root(a);
#endif
}

/// 2 atanh y, and the same less 2 y.
struct Logarithm {
  Lanes whole, rest;
};

/// As log_of_quotient (lanes.h): log(num/den) = 2 atanh(length/sum), from the latter where y = length/sum < 1/5. Where
/// it is not, `rest` is a difference that loses a digit or two, of what is then small against the middle's moments.
inline Logarithm logarithm(const Lanes& num, const Lanes& den, const Lanes& length, const Lanes& sum, const Lanes& y) {
  using lanes::Bits;
  constexpr std::uint64_t one = 1023;
  const Mask small = 5 * length < sum;
  const Bits bits = (Bits)num - (Bits)den + ((one << 52) + (UINT64_C(1) << 51));
  const Bits exponent = bits >> 52;
  const Lanes near_one = (Lanes)((Bits)num - ((exponent - one) << 52));
  const Lanes z = select(small, y, (near_one - den) / (near_one + den));
  const Lanes power = (Lanes)(exponent | UINT64_C(0x4330000000000000)) - (0x1p52 + static_cast<double>(one));
  const Lanes q = z * z, q2 = q * q, q4 = q2 * q2;
  const Lanes series =
      ((0.66666666666666663 + 0.40000000000007857 * q) + (0.28571428567313978 + 0.22222223042012851 * q) * q2) +
      ((0.18181738124060123 + 0.15388847910642214 * q) + (0.132100997526584 + 0.13606021764231466 * q) * q2) * q4;
  const Lanes cubic = (z * q) * series, near = 2 * z + cubic;
  const Lanes whole = power * 0.6931471805592082 + (near + power * 7.371002565167799e-13);
  return {select(small, near, whole), select(small, cubic, whole - 2 * y)};
}

/// Along a line, t the length from a point of it.
struct LineMoments {
  Lanes inverse, step;  ///< int t^j/r, j = 0, 1
  Lanes cube, c1, c2;   ///< int t^j/r^3, j = 0, 1, 2
};

/// About the middle. \param y length/sum, for the sum of the ends' distances \param middle its place from the foot
inline LineMoments about_middle(const Logarithm& log, const Lanes& y2, const Lanes& middle, const Lanes& cube) {
  const Lanes q = middle * y2;
  return {log.whole, -middle * log.rest, cube, -q * cube, log.rest + q * (q * cube)};
}

/// Along a line, t the length from a point of it: int r, int t r and int t^2/r.
struct GrowingMoments {
  Lanes r, step_r, step2;
};

/// About the middle. \param y length/sum \param height2 the squared distance from the line
inline GrowingMoments growing_about_middle(const Logarithm& log, const Lanes& y, const Lanes& sum, const Lanes& length,
                                           const Lanes& middle, const Lanes& height2) {
  const Lanes middle2 = middle * middle, cubic = middle2 * (y * y * y), quarter = 0.25 * length;
  const Lanes common = quarter * length * y - 0.5 * height2 * log.rest;
  return {middle2 * y + quarter * sum + 0.5 * height2 * log.whole, middle * (common - cubic * (1. / 3)),
          common - cubic + middle2 * log.rest};
}

/// About any point of the line, at `origin` from the foot, of lines that may end or pass next to the point that they
/// are seen from, at the squared distance `height2`: about the foot, which is then next to the origin, or, of lines
/// five times as far away as they are long, about the middle. \param t0 the start from the foot, t1 = t0 + length the
/// end
/// \param growing null, or where those moments go
inline LineMoments moments_about(const Lanes& origin, const Lanes& t0, const Lanes& t1, const Lanes& height2,
                                 const Lanes& length, GrowingMoments* growing = nullptr) {
  const Lanes square0 = height2 + t0 * t0, square1 = height2 + t1 * t1;
  const Lanes p0 = reciprocal_root(square0), p1 = reciprocal_root(square1);
  const Lanes r0 = square0 * p0, r1 = square1 * p1, both = p0 * p1, sum = r0 + r1, y = length / sum;
  // (r1 + t1)/(r0 + t0) in forms that add positive numbers, for the foot before the line, behind it and within.
  const Lanes a = r0 + lanes::magnitude(t0), b = r1 + lanes::magnitude(t1);
  const Mask before = t0 >= Lanes{}, behind = t1 <= Lanes{};
  const Lanes num = select(before, b, select(behind, a, a * b));
  const Lanes den = select(before, a, select(behind, b, height2));
  const Logarithm log = logarithm(num, den, length, sum, y);
  const Lanes middle = 0.5 * (t0 + t1), step = 2 * middle * y;
  const Lanes along = t1 * r0, other = t0 * r1;
  const Mask outside = before | behind;
  const Lanes cube =
      both * (select(outside, 2 * length * middle, along - other) / select(outside, along + other, height2));
  const LineMoments far = about_middle(log, y * y, middle, cube);
  const Lanes foot_c1 = step * both, foot_c2 = log.whole - height2 * cube;
  if (growing != nullptr) {
    const GrowingMoments about = growing_about_middle(log, y, sum, length, middle, height2);
    const Lanes from = middle - origin, first = -middle * log.rest;
    *growing = {about.r, about.step_r + from * about.r, about.step2 + from * (2 * first + from * log.whole)};
  }
  const Mask small = 5 * length < sum;
  const Lanes shift = select(small, middle - origin, -origin);
  const Lanes first = select(small, far.step, step), first3 = select(small, far.c1, foot_c1);
  const Lanes c1 = first3 + shift * cube;
  return {log.whole, first + shift * log.whole, cube, c1, select(small, far.c2, foot_c2) + shift * (first3 + c1)};
}

}  // namespace cageproof::adaptive_qmvc::batch::CAGEPROOF_SIMD
