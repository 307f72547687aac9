// SPDX-License-Identifier: MIT
// The built-in number that is nearest to one of MPFR's.
#pragma once

#include <mpfr.h>

#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>

namespace cageproof {

inline double by_mpfr(mpfr_srcptr x, double) { return mpfr_get_d(x, MPFR_RNDN); }
inline long double by_mpfr(mpfr_srcptr x, long double) { return mpfr_get_ld(x, MPFR_RNDN); }

// The number of that sign that is digits * 2^(exponent - 53), of 53 bits, or 2^53 itself.
inline double assembled(std::uint64_t digits, mpfr_exp_t exponent, bool negative, double) {
  constexpr int bias = 1023;
  // The highest of the digits, which is not stored, adds one to the exponent, as does what 53 bits do not hold.
  const std::uint64_t bits = (static_cast<std::uint64_t>(exponent + bias - 2) << 52) + digits;
  return std::bit_cast<double>(bits | static_cast<std::uint64_t>(negative) << 63);
}
// As above, of 64 bits, of which 2^64 is zero.
inline long double assembled(std::uint64_t digits, mpfr_exp_t exponent, bool negative, long double) {
  constexpr int bias = 16383;
  constexpr std::uint64_t highest = std::uint64_t{1} << 63;
  const auto head = static_cast<std::uint16_t>((exponent + bias - (digits == 0 ? 0 : 1)) | (negative ? 1 << 15 : 0));
  if (digits == 0) digits = highest;
  long double number = 0;
  std::memcpy(&number, &digits, sizeof digits);
  std::memcpy(reinterpret_cast<std::byte*>(&number) + sizeof digits, &head, sizeof head);
  return number;
}

// The nearest of F's numbers, ties to even. MPFR's own functions make a number of F's precision first, and the one for
// long double asks for memory, which takes as long as six products in 50 digits.
template <class F>
F nearest(mpfr_srcptr x) {
  using Limits = std::numeric_limits<F>;
  constexpr int digits = Limits::digits;
  static_assert(GMP_NUMB_BITS == 64);
  // IEEE's double, and the extended one of x86.
  constexpr bool is_known = std::endian::native == std::endian::little &&
                            ((digits == 53 && Limits::max_exponent == 1024 && sizeof(F) == 8) ||
                             (digits == 64 && Limits::max_exponent == 16384 && sizeof(F) >= 10));
  if constexpr (is_known) {
    // Numbers that are not F's normal ones, nor become so by rounding, are left to MPFR.
    const mpfr_exp_t exponent = mpfr_regular_p(x) != 0 ? mpfr_get_exp(x) : std::numeric_limits<mpfr_exp_t>::max();
    if (exponent > Limits::min_exponent && exponent < Limits::max_exponent) {
      const auto* const limbs = static_cast<const std::uint64_t*>(mpfr_custom_get_significand(x));
      const auto last = static_cast<std::size_t>((mpfr_get_prec(x) - 1) / 64);
      constexpr int unused = 64 - digits;
      std::uint64_t top = limbs[last], half = 0, below = 0;
      std::size_t whole = last;  // limbs that only tell whether anything is below
      if constexpr (unused > 0) {
        half = top >> (unused - 1) & 1;
        below = top & ((std::uint64_t{1} << (unused - 1)) - 1);
        top >>= unused;
      } else if (last > 0) {
        whole = last - 1;
        half = limbs[whole] >> 63;
        below = limbs[whole] << 1;
      }
      for (std::size_t i = 0; i < whole; ++i) below |= limbs[i];
      const std::uint64_t up = half & static_cast<std::uint64_t>(below != 0 || (top & 1) != 0);
      return assembled(top + up, exponent, mpfr_signbit(x) != 0, F());
    }
  }
  return by_mpfr(x, F());
}

}  // namespace cageproof
