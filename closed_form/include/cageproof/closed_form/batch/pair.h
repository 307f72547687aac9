// SPDX-License-Identifier: MIT
// Double-doubles, one per point, and the functions that kernels take of them. Operations are good to 2^-100 of their
// operands, not of their results: sums that cancel keep the error of their terms. Compile without contraction of
// products and sums.
#pragma once

#include "cageproof/closed_form/batch/lanes.h"
#include "cageproof/closed_form/batch/tables.h"

namespace cageproof::closed_form::batch::CAGEPROOF_SIMD {

/// The unevaluated sum of two numbers per point.
struct Pair {
  Lanes high{}, low{};

  Pair() = default;
  Pair(Lanes h, Lanes l = Lanes{}) : high(h), low(l) {}
  Pair(double x) : high(splat(x)) {}
  Pair(const TwoDoubles& c) : high(splat(c.high)), low(splat(c.low)) {}
};

/// a + b exactly, for |a| >= |b|.
inline Pair ordered_sum(Lanes a, Lanes b) {
  const Lanes s = a + b;
  return {s, b - (s - a)};
}
/// a + b exactly.
inline Pair exact_sum(Lanes a, Lanes b) {
  const Lanes s = a + b, t = s - a;
  return {s, (a - (s - t)) + (b - t)};
}
/// a b exactly.
inline Pair exact_product(Lanes a, Lanes b) {
  const Lanes p = a * b;
#if defined(__FMA__) || defined(__ARM_FEATURE_FMA)
  Lanes e;
  for (int i = 0; i < kLanes; ++i) e[i] = __builtin_fma(a[i], b[i], -p[i]);
  return {p, e};
#else
  // Dekker's halves of 26 bits.
  const Lanes ta = a * 134217729.0, tb = b * 134217729.0;
  const Lanes ah = ta - (ta - a), al = a - ah, bh = tb - (tb - b), bl = b - bh;
  return {p, ((ah * bh - p) + ah * bl + al * bh) + al * bl};
#endif
}

inline Pair operator-(const Pair& a) { return {-a.high, -a.low}; }
inline Pair operator+(const Pair& a, const Pair& b) {
  const Pair s = exact_sum(a.high, b.high);
  return ordered_sum(s.high, s.low + (a.low + b.low));
}
inline Pair operator-(const Pair& a, const Pair& b) { return a + (-b); }
inline Pair operator*(const Pair& a, const Pair& b) {
  const Pair p = exact_product(a.high, b.high);
  return ordered_sum(p.high, p.low + (a.high * b.low + a.low * b.high));
}
inline Pair operator/(const Pair& a, const Pair& b) {
  const Lanes first = a.high / b.high;
  const Pair rest = a - b * Pair(first);
  return ordered_sum(first, rest.high / b.high);
}
inline Pair& operator+=(Pair& a, const Pair& b) { return a = a + b; }

inline Pair select(Mask m, const Pair& a, const Pair& b) {
  return {select(m, a.high, b.high), select(m, a.low, b.low)};
}
inline Mask less(const Pair& a, const Pair& b) { return (a.high < b.high) | ((a.high == b.high) & (a.low < b.low)); }
inline Pair magnitude(const Pair& a) { return select(a.high < Lanes{}, -a, a); }

inline Pair root(const Pair& a) {
  const Lanes r = root(a.high);
  const Pair rest = a - exact_product(r, r);
  const Lanes step = rest.high / (2 * r);
  return ordered_sum(r, select(r > Lanes{}, step, Lanes{}));
}

/// 1, 1/3, 1/5 ... of the series of arc tangents.
inline constexpr TwoDoubles kOdd[] = {{0x1.0000000000000p+0, 0x0.0p+0},
                                      {0x1.5555555555555p-2, 0x1.5555555555555p-56},
                                      {0x1.999999999999ap-3, -0x1.999999999999ap-57},
                                      {0x1.2492492492492p-3, 0x1.2492492492492p-57},
                                      {0x1.c71c71c71c71cp-4, 0x1.c71c71c71c71cp-58},
                                      {0x1.745d1745d1746p-4, -0x1.745d1745d1746p-59},
                                      {0x1.3b13b13b13b14p-4, -0x1.3b13b13b13b14p-58},
                                      {0x1.1111111111111p-4, 0x1.1111111111111p-60},
                                      {0x1.e1e1e1e1e1e1ep-5, 0x1.e1e1e1e1e1e1ep-61},
                                      {0x1.af286bca1af28p-5, 0x1.af286bca1af28p-59},
                                      {0x1.8618618618618p-5, 0x1.8618618618618p-59},
                                      {0x1.642c8590b2164p-5, 0x1.642c8590b2164p-60},
                                      {0x1.47ae147ae147bp-5, -0x1.eb851eb851eb8p-61},
                                      {0x1.2f684bda12f68p-5, 0x1.2f684bda12f68p-59},
                                      {0x1.1a7b9611a7b96p-5, 0x1.1a7b9611a7b96p-61},
                                      {0x1.0842108421084p-5, 0x1.0842108421084p-60}};

/// sum of s^k (+-1)^k/(2 k + 1), |s| <= 0.072: 30 terms, of which the last 14 need no more than a double's digits.
inline Pair series_of_odd(const Pair& s, double sign) {
  const Lanes signed_s = sign * s.high;
  Lanes tail{};
  for (int k = 29; k >= 16; --k) tail = 1.0 / (2 * k + 1) + signed_s * tail;
  Pair sum(signed_s * tail);
  const Pair step = sign < 0 ? -s : s;
  for (int k = 15; k >= 0; --k) sum = Pair(kOdd[k]) + (k == 15 ? sum : step * sum);
  return sum;
}

/// log(num/den), with length and sum as for Lanes (lanes.h).
inline Pair log_of_quotient(const Pair& num, const Pair& den, const Pair& length, const Pair& sum) {
  constexpr std::uint64_t one = 1023;
  const Bits bits = (Bits)num.high - (Bits)den.high + ((one << 52) + (UINT64_C(1) << 51));
  const Bits exponent = bits >> 52;
  // 2^-k is a normal number, because no quotient here is near the ends of double's range.
  const Lanes scale = (Lanes)((2 * one - exponent) << 52);
  const Pair near_one(num.high * scale, num.low * scale);
  const Mask small = 5 * length.high < sum.high;
  const Pair z = select(small, length, near_one - den) / select(small, sum, near_one + den);
  const Lanes power = (Lanes)(exponent | UINT64_C(0x4330000000000000)) - (0x1p52 + static_cast<double>(one));
  const Pair rest = Pair(2.0) * z * series_of_odd(z * z, 1);
  const Pair ln_2(TwoDoubles{0x1.62e42fefa39efp-1, 0x1.abc9e3b39803fp-56});
  return select(small, rest, rest + Pair(power) * ln_2);
}

inline Pair angle_of(const Pair& y, const Pair& x) {
  const Pair ay = magnitude(y), ax = magnitude(x);
  const Mask steep = less(ax, ay);
  const Pair large = select(steep, ay, ax), small = select(steep, ax, ay);
  const Pair tan_30(TwoDoubles{0x1.279a74590331cp-1, 0x1.34863e0792bedp-55});
  const Mask between = small.high > 0.26794919243112270 * large.high;
  const Pair c = select(between, tan_30, Pair());
  const Pair q = (small - c * large) / (large + c * small);
  Pair angle = q * series_of_odd(q * q, -1);
  const Pair sixth(TwoDoubles{0x1.0c152382d7366p-1, -0x1.ee6913347c2a6p-55});
  angle = select(between, sixth + angle, angle);
  angle = select(steep, Pair(TwoDoubles{0x1.921fb54442d18p+0, 0x1.1a62633145c07p-54}) - angle, angle);
  angle = select(x.high < Lanes{}, Pair(TwoDoubles{0x1.921fb54442d18p+1, 0x1.1a62633145c07p-53}) - angle, angle);
  return select(y.high < Lanes{}, -angle, angle);
}

}  // namespace cageproof::closed_form::batch::CAGEPROOF_SIMD
