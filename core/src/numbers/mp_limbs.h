// SPDX-License-Identifier: MIT
// Sums and products in two thirds of MPFR's time, because the number of limbs is known when they are compiled: most of a
// verification's time goes into numbers of 50 and 100 digits. The results are MPFR's to the last bit: the nearest
// numbers, and the even one where two are equally near.
#pragma once

#include <mpfr.h>

#include <array>
#include <bit>
#include <cstdint>
#include <cstdlib>
#include <utility>

namespace cageproof::mp_work {

/// Numbers of so many bits. Each function answers false, and leaves the result as it is, where MPFR must do the work:
/// for zero, infinities, NaN, differences that are zero, and exponents that a product might take out of range. The
/// result may be one of the operands.
template <unsigned Bits>
class Limbs {
 public:
  static bool multiply(mpfr_ptr result, mpfr_srcptr a, mpfr_srcptr b) {
    if (!is_ordinary(a) || !is_ordinary(b)) return false;
    const Limb *x = limbs_of(a), *y = limbs_of(b);
    std::array<Limb, 2 * kLimbs> product{};
    for (int i = 0; i < kLimbs; ++i) {
      Limb carry = 0;
      for (int j = 0; j < kLimbs; ++j) {
        const Wide term = static_cast<Wide>(x[i]) * y[j] + product[i + j] + carry;
        product[i + j] = static_cast<Limb>(term);
        carry = static_cast<Limb>(term >> 64);
      }
      product[i + kLimbs] = carry;
    }
    // By a bit or by none, without a branch that nobody can predict.
    const Limb up = (product[2 * kLimbs - 1] >> 63) ^ 1;
    std::array<Limb, kLimbs> high;
    for (int i = 0; i < kLimbs; ++i) high[i] = product[kLimbs + i] << up | (product[kLimbs + i - 1] >> 63 & -up);
    Limb rest = product[kLimbs - 1] << up;
    for (int i = 0; i < kLimbs - 1; ++i) rest |= product[i];
    put(result, MPFR_SIGN(a) * MPFR_SIGN(b), exponent_of(a) + exponent_of(b) - static_cast<mpfr_exp_t>(up), high.data(),
        rest != 0);
    return true;
  }

  /// \param sign of b: 1 for the sum, -1 for the difference
  static bool add(mpfr_ptr result, mpfr_srcptr a, mpfr_srcptr b, int sign) {
    if (!is_ordinary(a) || !is_ordinary(b)) return false;
    int large_sign = MPFR_SIGN(a), small_sign = sign * MPFR_SIGN(b);
    mpfr_srcptr large = a, small = b;
    if (is_smaller(a, b)) {
      std::swap(large, small);
      std::swap(large_sign, small_sign);
    }
    mpfr_exp_t exponent = exponent_of(large);
    const mpfr_exp_t shift = exponent - exponent_of(small);
    const Limb* x = limbs_of(large);
    // The smaller one is less than half of the last bit, also below a power of two.
    if (shift > Bits + 1) {
      put(result, large_sign, exponent, x, false);
      return true;
    }
    // One limb below the others, whose last bit says whether something lies below it.
    Longer y = shifted(limbs_of(small), static_cast<int>(shift));
    if (large_sign == small_sign) {
      Limb carry = 0;
      for (int i = 0; i < kLimbs; ++i) {
        const Wide sum = static_cast<Wide>(x[i]) + y[i + 1] + carry;
        y[i + 1] = static_cast<Limb>(sum);
        carry = static_cast<Limb>(sum >> 64);
      }
      if (carry != 0) {
        y[0] = y[0] >> 1 | (y[0] & 1) | y[1] << 63;
        for (int i = 1; i < kLimbs; ++i) y[i] = y[i] >> 1 | y[i + 1] << 63;
        y[kLimbs] = y[kLimbs] >> 1 | Limb{1} << 63;
        ++exponent;
      }
    } else {
      Limb borrow = y[0] != 0 ? 1 : 0, all = y[0];
      y[0] = -y[0];
      for (int i = 0; i < kLimbs; ++i) {
        const Wide difference = static_cast<Wide>(x[i]) - y[i + 1] - borrow;
        y[i + 1] = static_cast<Limb>(difference);
        borrow = static_cast<Limb>(difference >> 64) & 1;
        all |= y[i + 1];
      }
      if (all == 0) return false;
      exponent -= normalise(y);
    }
    put(result, large_sign, exponent, y.data() + 1, y[0] != 0);
    return true;
  }

 private:
  using Limb = std::uint64_t;
  __extension__ using Wide = unsigned __int128;
  static constexpr int kLimbs = (Bits + 63) / 64;
  using Longer = std::array<Limb, kLimbs + 1>;
  // The lowest limb has bits to round away.
  static_assert(GMP_NUMB_BITS == 64 && 64 * kLimbs - Bits >= 2);

  static mpfr_exp_t exponent_of(mpfr_srcptr x) { return mpfr_custom_get_exp(x); }
  static const Limb* limbs_of(mpfr_srcptr x) { return static_cast<const Limb*>(mpfr_custom_get_significand(x)); }
  // Zero, infinities and NaN have the least exponents.
  static bool is_ordinary(mpfr_srcptr x) { return std::abs(exponent_of(x) / 2) < mpfr_exp_t{1} << 30; }

  static bool is_smaller(mpfr_srcptr a, mpfr_srcptr b) {
    if (exponent_of(a) != exponent_of(b)) return exponent_of(a) < exponent_of(b);
    const Limb *x = limbs_of(a), *y = limbs_of(b);
    int i = kLimbs - 1;
    while (i > 0 && x[i] == y[i]) --i;
    return x[i] < y[i];
  }

  static Longer shifted(const Limb* limbs, int shift) {
    Longer y{};
    const int whole = shift / 64, bits = shift % 64;
    Limb lost = 0;
    // Limb i of the longer number is limb i - 1 of the shorter one.
    for (int i = 0; i < kLimbs; ++i) {
      const int to = i + 1 - whole;
      if (to >= 0) y[to] = limbs[i];
      else lost |= limbs[i];
    }
    if (bits > 0) {
      lost |= y[0] << (64 - bits);
      for (int i = 0; i < kLimbs; ++i) y[i] = y[i] >> bits | y[i + 1] << (64 - bits);
      y[kLimbs] >>= bits;
    }
    if (lost != 0) y[0] |= 1;
    return y;
  }

  // Shifts the highest bit to the top. \pre there is one \return by how many bits
  static int normalise(Longer& y) {
    int shift = 0;
    for (; y[kLimbs] == 0; shift += 64) {
      for (int i = kLimbs; i > 0; --i) y[i] = y[i - 1];
      y[0] = 0;
    }
    if (const int zeros = std::countl_zero(y[kLimbs]); zeros > 0) {
      for (int i = kLimbs; i > 0; --i) y[i] = y[i] << zeros | y[i - 1] >> (64 - zeros);
      y[0] <<= zeros;
      shift += zeros;
    }
    return shift;
  }

  // Rounds to Bits. \param rest whether something lies below the limbs
  static void put(mpfr_ptr result, int sign, mpfr_exp_t exponent, const Limb* from, bool rest) {
    constexpr Limb unit = Limb{1} << (64 * kLimbs - Bits), half = unit / 2;
    // Beyond the half up, and from the half to an even number.
    const Limb half_up = rest || (from[0] & unit) != 0 ? half : half - 1;
    auto* const to = static_cast<Limb*>(mpfr_custom_get_significand(result));
    Wide sum = static_cast<Wide>(from[0]) + half_up;
    to[0] = static_cast<Limb>(sum) & ~(unit - 1);
    for (int i = 1; i < kLimbs; ++i) {
      sum = (sum >> 64) + from[i];
      to[i] = static_cast<Limb>(sum);
    }
    if ((sum >> 64) != 0) {
      to[kLimbs - 1] = Limb{1} << 63;
      ++exponent;
    }
    mpfr_custom_init_set(result, sign * MPFR_REGULAR_KIND, exponent, Bits, to);
  }
};

}  // namespace cageproof::mp_work
