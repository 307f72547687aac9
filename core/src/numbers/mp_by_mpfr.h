// SPDX-License-Identifier: MIT
// The work of the multiprecision numbers, done by MPFR.
#pragma once

#include "mp_nearest.h"

#include "cageproof/core/numbers/mp_number.h"

#include <boost/math/constants/constants.hpp>

namespace cageproof::mp_work {

template <unsigned D>
void add(Mp<D>& result, const Mp<D>& a, const Mp<D>& b) {
  mpfr_add(result.data(), a.data(), b.data(), MPFR_RNDN);
}
template <unsigned D>
void subtract(Mp<D>& result, const Mp<D>& a, const Mp<D>& b) {
  mpfr_sub(result.data(), a.data(), b.data(), MPFR_RNDN);
}

/// A factor or divisor without its low limbs that are zero. Integers, doubles and coordinates have few others, and MPFR
/// takes a product or quotient by few limbs in a half to a fifth of the time. The result has the same bits.
class FewLimbs {
 public:
  /// \param result where the number itself is to be overwritten, it is taken whole
  template <unsigned D>
  FewLimbs(const Mp<D>& x, const Mp<D>& result) : seen_(x.data()) {
    if (&x == &result || mpfr_regular_p(seen_) == 0) return;
    auto* const limb = static_cast<mp_limb_t*>(mpfr_custom_get_significand(seen_));
    int zeros = 0;
    while (limb[zeros] == 0) ++zeros;  // the highest limb is not
    if (zeros == 0) return;
    constexpr int limbs = (Mp<D>::bits + GMP_NUMB_BITS - 1) / GMP_NUMB_BITS;
    mpfr_custom_init_set(&few_, mpfr_custom_get_kind(seen_), mpfr_custom_get_exp(seen_),
                         GMP_NUMB_BITS * (limbs - zeros), limb + zeros);
    seen_ = &few_;
  }
  FewLimbs(const FewLimbs&) = delete;
  FewLimbs& operator=(const FewLimbs&) = delete;
  mpfr_srcptr data() const { return seen_; }

 private:
  __mpfr_struct few_;
  mpfr_srcptr seen_;
};

template <unsigned D>
void multiply(Mp<D>& result, const Mp<D>& a, const Mp<D>& b) {
  // MPFR has its quickest product for factors of three limbs each.
  if constexpr (D == 50) mpfr_mul(result.data(), a.data(), b.data(), MPFR_RNDN);
  else mpfr_mul(result.data(), FewLimbs(a, result).data(), FewLimbs(b, result).data(), MPFR_RNDN);
}
template <unsigned D>
void divide(Mp<D>& result, const Mp<D>& a, const Mp<D>& b) {
  mpfr_div(result.data(), a.data(), FewLimbs(b, result).data(), MPFR_RNDN);
}
template <unsigned D>
void negate(Mp<D>& result, const Mp<D>& a) {
  mpfr_neg(result.data(), a.data(), MPFR_RNDN);
}
template <unsigned D>
void hypot(Mp<D>& result, const Mp<D>& x, const Mp<D>& y) {
  mpfr_hypot(result.data(), x.data(), y.data(), MPFR_RNDN);
}

/// The number that functions are called with, one after rounding, and back.
template <unsigned D>
const MpNumber<D>& wide(const Mp<D>& x) {
  return number_of(x);
}
template <unsigned D>
const MpNumber<D>& narrow(const MpNumber<D>& x) {
  return x;
}

template <class F, unsigned D>
F nearest(const Mp<D>& x) {
  return cageproof::nearest<F>(x.data());
}
template <unsigned D>
std::int64_t exponent(const Mp<D>& x) {
  return mpfr_regular_p(x.data()) != 0 ? std::int64_t{mpfr_get_exp(x.data())} : Mp<D>::kNoExponent;
}

}  // namespace cageproof::mp_work
