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
template <unsigned D>
void multiply(Mp<D>& result, const Mp<D>& a, const Mp<D>& b) {
  mpfr_mul(result.data(), a.data(), b.data(), MPFR_RNDN);
}
template <unsigned D>
void divide(Mp<D>& result, const Mp<D>& a, const Mp<D>& b) {
  mpfr_div(result.data(), a.data(), b.data(), MPFR_RNDN);
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
