// SPDX-License-Identifier: MIT
// Sums and products of MPFR's numbers of three limbs, which those of 50 digits are, with the same bits as MPFR's and in
// half of its time: there is no loop, and hardly a branch that data decides. MPFR's own are left what is rare: zeros,
// infinities, exponents next to the ends of the range, and differences that vanish.
#pragma once

#include <mpfr.h>

#include <bit>
#include <cstdint>

namespace cageproof::three_limbs {

using Limb = std::uint64_t;
__extension__ using TwoLimbs = unsigned __int128;

/// Whether numbers of so many bits have three limbs, the lowest of which has bits to spare.
constexpr bool hold(unsigned bits) { return GMP_NUMB_BITS == 64 && bits > 128 && bits < 191; }

/// A significand: its highest bit is set, and the bits that the lowest limb has too many are zero.
struct Limbs {
  Limb low, middle, high;
};

inline Limbs limbs_of(mpfr_srcptr x) { return {x->_mpfr_d[0], x->_mpfr_d[1], x->_mpfr_d[2]}; }

/// Whether x is a number other than zero whose sums and products stay within MPFR's range of exponents.
inline bool is_plain(mpfr_srcptr x) {
  constexpr mpfr_exp_t far = mpfr_exp_t{1} << 27;
  return x->_mpfr_exp > -far && x->_mpfr_exp < far;
}

/// The higher limb of two after a shift to the left by 0 to 63 bits.
inline Limb shifted(Limb high, Limb low, int bits) { return high << bits | low >> 1 >> (63 - bits); }

/// Adds b and the carry, which it sets anew.
inline Limb add(Limb a, Limb b, Limb& carry) {
  const TwoLimbs sum = TwoLimbs{a} + b + carry;
  carry = static_cast<Limb>(sum >> 64);
  return static_cast<Limb>(sum);
}

/// Sets r to a significand rounded to nearest, ties to even. \param below not zero where the significand goes on
template <unsigned Bits>
void set_rounded(mpfr_ptr r, Limbs x, Limb below, int sign, mpfr_exp_t exponent) {
  constexpr Limb last = Limb{1} << (192 - Bits), half = last >> 1;
  const bool up = (x.low & half) != 0 && ((x.low & (half - 1)) | below | (x.low & last)) != 0;
  Limb carry = 0;
  r->_mpfr_d[0] = add(x.low & ~(last - 1), up ? last : 0, carry);
  r->_mpfr_d[1] = add(x.middle, 0, carry);
  // All bits were ones if there is still a carry.
  r->_mpfr_d[2] = add(x.high, 0, carry) | carry << 63;
  r->_mpfr_exp = exponent + static_cast<mpfr_exp_t>(carry);
  r->_mpfr_sign = sign;
}

/// Sets r to a b, all of Bits bits; r may be a or b. \return false where nothing was done
template <unsigned Bits>
bool multiply(mpfr_ptr r, mpfr_srcptr a, mpfr_srcptr b) {
  if (!is_plain(a) || !is_plain(b)) return false;
  const Limbs x = limbs_of(a), y = limbs_of(b);
  const auto low = [](TwoLimbs p) { return static_cast<Limb>(p); };
  const auto high = [](TwoLimbs p) { return p >> 64; };
  const TwoLimbs p00 = TwoLimbs{x.low} * y.low, p01 = TwoLimbs{x.low} * y.middle, p10 = TwoLimbs{x.middle} * y.low,
                 p02 = TwoLimbs{x.low} * y.high, p11 = TwoLimbs{x.middle} * y.middle, p20 = TwoLimbs{x.high} * y.low,
                 p12 = TwoLimbs{x.middle} * y.high, p21 = TwoLimbs{x.high} * y.middle, p22 = TwoLimbs{x.high} * y.high;
  // Columns of the product, with what the one to the right carries.
  const TwoLimbs c1 = high(p00) + low(p01) + low(p10);
  const TwoLimbs c2 = high(c1) + high(p01) + high(p10) + low(p02) + low(p11) + low(p20);
  const TwoLimbs c3 = high(c2) + high(p02) + high(p11) + high(p20) + low(p12) + low(p21);
  const TwoLimbs c4 = high(c3) + high(p12) + high(p21) + p22;
  const Limb w2 = low(c2), w3 = low(c3), w4 = low(c4), w5 = low(high(c4));
  const int zeros = w5 >> 63 == 0 ? 1 : 0;
  const Limbs product{shifted(w3, w2, zeros), shifted(w4, w3, zeros), shifted(w5, w4, zeros)};
  set_rounded<Bits>(r, product, w2 << zeros | low(c1) | low(p00), a->_mpfr_sign * b->_mpfr_sign,
                    a->_mpfr_exp + b->_mpfr_exp - zeros);
  return true;
}

/// Sets r to a + b, all of Bits bits, where b counts with the sign `sign_of_b`; r may be a or b. \return false where
/// nothing was done
template <unsigned Bits>
bool add(mpfr_ptr r, mpfr_srcptr a, mpfr_srcptr b, int sign_of_b) {
  if (!is_plain(a) || !is_plain(b)) return false;
  int sign = a->_mpfr_sign;
  const Limb all_if_differing = sign == sign_of_b ? 0 : ~Limb{0};
  const bool swap = a->_mpfr_exp < b->_mpfr_exp;
  if (swap) sign = sign_of_b;
  const mpfr_srcptr larger = swap ? b : a, smaller = swap ? a : b;
  const mpfr_exp_t exponent = larger->_mpfr_exp, distance = exponent - smaller->_mpfr_exp;
  const Limbs x = limbs_of(larger), y = limbs_of(smaller);
  // Less than a quarter of the last bit, which even a difference that has one bit fewer rounds away.
  if (distance >= static_cast<mpfr_exp_t>(Bits) + 2) {
    set_rounded<Bits>(r, x, 0, sign, exponent);
    return true;
  }
  // Both one bit to the right, for the carry, and the smaller as far as it is smaller, into one limb more.
  const Limb x1 = x.low >> 1 | x.middle << 63, x2 = x.middle >> 1 | x.high << 63, x3 = x.high >> 1;
  const int shift = static_cast<int>(distance) + 1, bits = shift & 63;
  const bool one = (shift & 64) != 0, two = (shift & 128) != 0;
  Limb y0 = one ? y.low : 0, y1 = one ? y.middle : y.low, y2 = one ? y.high : y.middle, y3 = one ? 0 : y.high;
  Limb below = two ? y0 | y1 : 0;
  y0 = two ? y2 : y0;
  y1 = two ? y3 : y1;
  y2 = two ? 0 : y2;
  y3 = two ? 0 : y3;
  below |= y0 & ((Limb{1} << bits) - 1);
  const auto moved = [bits](Limb high, Limb low) { return low >> bits | high << 1 << (63 - bits); };
  // A difference is the sum with the complement. What is below then lies between zero and one unit of the lowest limb.
  Limb carry = all_if_differing & (below == 0 ? 1 : 0);
  Limb w0 = add(0, moved(y1, y0) ^ all_if_differing, carry);
  Limb w1 = add(x1, moved(y2, y1) ^ all_if_differing, carry);
  Limb w2 = add(x2, moved(y3, y2) ^ all_if_differing, carry);
  Limb w3 = add(x3, y3 >> bits ^ all_if_differing, carry);
  // With equal exponents the first may be the smaller: there is no carry then, and the sum is the complement.
  const Limb all_if_negative = all_if_differing & (carry - 1);
  sign = all_if_negative == 0 ? sign : -sign;
  carry = all_if_negative & 1;
  w0 = add(w0 ^ all_if_negative, 0, carry);
  w1 = add(w1 ^ all_if_negative, 0, carry);
  w2 = add(w2 ^ all_if_negative, 0, carry);
  w3 = add(w3 ^ all_if_negative, 0, carry);
  int lost = 0;
  while (w3 == 0) {
    if (lost == 192) return false;
    w3 = w2;
    w2 = w1;
    w1 = w0;
    w0 = 0;
    lost += 64;
  }
  const int zeros = std::countl_zero(w3);
  const Limbs sum{shifted(w1, w0, zeros), shifted(w2, w1, zeros), shifted(w3, w2, zeros)};
  set_rounded<Bits>(r, sum, w0 << zeros | below, sign, exponent + 1 - lost - zeros);
  return true;
}

}  // namespace cageproof::three_limbs
