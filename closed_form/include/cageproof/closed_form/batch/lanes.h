// SPDX-License-Identifier: MIT
// A vector of doubles, one per point, and the functions that kernels take of it. One source for every instruction set:
// the namespace has its name, so that no function of one is taken for another's.
#pragma once

#include <cstdint>

#if defined(__AVX512F__) && defined(__AVX512DQ__)
#define CAGEPROOF_SIMD avx512
#define CAGEPROOF_LANES 8
#elif defined(__AVX2__)
#define CAGEPROOF_SIMD avx2
#define CAGEPROOF_LANES 4
#else
#define CAGEPROOF_SIMD plain
#define CAGEPROOF_LANES 2
#endif

namespace cageproof::closed_form::batch::CAGEPROOF_SIMD {

inline constexpr int kLanes = CAGEPROOF_LANES;

/// One number per point.
using Lanes = double __attribute__((vector_size(8 * CAGEPROOF_LANES)));
/// One truth value per point: all bits, or none. Also the bits of numbers.
using Mask = std::int64_t __attribute__((vector_size(8 * CAGEPROOF_LANES)));
using Bits = std::uint64_t __attribute__((vector_size(8 * CAGEPROOF_LANES)));

inline Lanes splat(double x) { return x - Lanes{}; }
inline Lanes select(Mask m, Lanes a, Lanes b) { return m ? a : b; }
inline Lanes magnitude(Lanes a) { return (Lanes)((Mask)a & INT64_MAX); }
inline Mask less(Lanes a, Lanes b) { return a < b; }

inline bool any(Mask m) {
  std::int64_t all = 0;
  for (int i = 0; i < kLanes; ++i) all |= m[i];
  return all != 0;
}

inline Lanes root(Lanes a) {
  Lanes r = a;
  for (int i = 0; i < kLanes; ++i) r[i] = __builtin_sqrt(r[i]);
  return r;
}

/// 1/sqrt(a) within two roundings, of numbers from 1e-30 to 1e30.
inline Lanes over_root(Lanes a) {
#if defined(__AVX512F__) && defined(__AVX512DQ__)
  const Lanes y = __builtin_ia32_rsqrt14pd512_mask(a, Lanes{}, 0xff);
#elif defined(__AVX2__)
  using Four = float __attribute__((vector_size(16)));
  const Four rough = __builtin_ia32_rsqrtps(__builtin_convertvector(a, Four));
  const Lanes y = __builtin_convertvector(rough, Lanes);
#else
  return 1 / root(a);
#endif
#if defined(__AVX2__)
  // y (1 - left)^(-1/2), whose next term is 2^-58 at most.
  const Lanes left = 1 - (a * y) * y;
  return y + (y * left) * (0.5 + left * (0.375 + left * (0.3125 + left * 0.2734375)));
#endif
}

/// 1/a within two roundings, of numbers from 1e-30 to 1e30.
inline Lanes reciprocal(Lanes a) {
#if defined(__AVX512F__) && defined(__AVX512DQ__)
  // y/(1 - left), whose next term is 2^-56 at most.
  const Lanes y = __builtin_ia32_rcp14pd512_mask(a, Lanes{}, 0xff);
  const Lanes left = 1 - a * y;
  return y + (y * left) * (1 + left * (1 + left));
#else
  return 1 / a;
#endif
}

/// log(num/den), both positive: ((sum + length)/(sum - length)) in any form that does not cancel. Where length is small
/// against sum, as `small` says, 2 atanh(length/sum) is taken, which keeps all digits of a small result.
///
/// One division: the quotient is brought next to one by a power of two, and log x = 2 atanh((x - 1)/(x + 1)), whose
/// series is replaced by Chebyshev's polynomial for |z| <= 1/5. \param after_first if not null: where `small`, what
/// comes after 2 length/sum
inline Lanes log_of_quotient(Lanes num, Lanes den, Lanes length, Lanes sum, Mask small, Lanes* after_first) {
  constexpr std::uint64_t one = 1023;
  const Bits bits = (Bits)num - (Bits)den + ((one << 52) + (UINT64_C(1) << 51));
  const Bits exponent = bits >> 52;  // of the power of two, plus `one`
  const Lanes near_one = (Lanes)((Bits)num - ((exponent - one) << 52));
  const Lanes z = select(small, length, near_one - den) / select(small, sum, near_one + den);
  const Lanes power = (Lanes)(exponent | UINT64_C(0x4330000000000000)) - (0x1p52 + static_cast<double>(one));
  const Lanes q = z * z, q2 = q * q, q4 = q2 * q2;
  const Lanes series =
      ((0.66666666666666663 + 0.40000000000007857 * q) + (0.28571428567313978 + 0.22222223042012851 * q) * q2) +
      ((0.18181738124060123 + 0.15388847910642214 * q) + (0.132100997526584 + 0.13606021764231466 * q) * q2) * q4;
  // The logarithm of two in two parts, the first of which has zeros to multiply whole numbers with.
  const Lanes after = (z * q) * series, rest = 2 * z + after;
  const Lanes whole = power * 0.6931471805592082 + (rest + power * 7.371002565167799e-13);
  if (after_first != nullptr) *after_first = after;
  return select(small, rest, whole);
}
inline Lanes log_of_quotient(Lanes num, Lanes den, Lanes length, Lanes sum, Mask small) {
  return log_of_quotient(num, den, length, sum, small, nullptr);
}

/// The logarithm of num/den for an edge of positive length.
inline Lanes log_of_quotient(Lanes num, Lanes den, Lanes length, Lanes sum) {
  return log_of_quotient(num, den, length, sum, 5 * length < sum);
}

/// The angle of (x, y) in [-pi, pi], by one division: within thirty degrees of an axis, or of a ray between two.
inline Lanes angle_of(Lanes y, Lanes x) {
  const Lanes ay = magnitude(y), ax = magnitude(x);
  const Mask steep = ay > ax;
  const Lanes large = select(steep, ay, ax), small = select(steep, ax, ay);
  constexpr double tan_15 = 0.26794919243112270, tan_30 = 0.57735026918962573;
  const Mask between = small > tan_15 * large;
  const Lanes c = select(between, splat(tan_30), Lanes{});
  const Lanes q = (small - c * large) / (large + c * small);
  const Lanes s = q * q, s2 = s * s, s4 = s2 * s2;
  const Lanes series =
      ((-0.33333333333333331 + 0.19999999999996876 * s) + (-0.14285714284552253 + 0.11111110944326062 * s) * s2) +
      (((-0.090908970702215042 + 0.076918192728124127 * s) + (-0.066549385862194027 + 0.057162705785596887 * s) * s2) -
       0.03957673535503866 * s4) *
          s4;
  Lanes angle = select(between, splat(0.52359877559829882), Lanes{}) + (q + (q * s) * series);
  angle = select(steep, 1.5707963267948966 - angle, angle);
  angle = select(x < Lanes{}, 3.1415926535897931 - angle, angle);
  return (Lanes)((Mask)angle | ((Mask)y & INT64_MIN));
}

}  // namespace cageproof::closed_form::batch::CAGEPROOF_SIMD

// Numbers that are vectors belong to no namespace in which templates would look for their functions.
namespace cageproof::closed_form::batch {
using CAGEPROOF_SIMD::angle_of;
using CAGEPROOF_SIMD::any;
using CAGEPROOF_SIMD::less;
using CAGEPROOF_SIMD::log_of_quotient;
using CAGEPROOF_SIMD::magnitude;
using CAGEPROOF_SIMD::root;
using CAGEPROOF_SIMD::select;
}  // namespace cageproof::closed_form::batch
