// SPDX-License-Identifier: MIT
// The work of the multiprecision numbers, done by Boost's cpp_bin_float, which needs no library.
#pragma once

#include "cageproof/core/numbers/mp_number.h"

#include <boost/math/constants/constants.hpp>

namespace cageproof::mp_work {

template <unsigned D>
void add(Mp<D>& result, const Mp<D>& a, const Mp<D>& b) {
  number_of(result) = number_of(a) + number_of(b);
}
template <unsigned D>
void subtract(Mp<D>& result, const Mp<D>& a, const Mp<D>& b) {
  number_of(result) = number_of(a) - number_of(b);
}
template <unsigned D>
void multiply(Mp<D>& result, const Mp<D>& a, const Mp<D>& b) {
  number_of(result) = number_of(a) * number_of(b);
}
template <unsigned D>
void divide(Mp<D>& result, const Mp<D>& a, const Mp<D>& b) {
  number_of(result) = number_of(a) / number_of(b);
}
template <unsigned D>
void negate(Mp<D>& result, const Mp<D>& a) {
  number_of(result) = -number_of(a);
}

/// Boost's functions are off by some units of their type: they are computed in 64 bits more.
template <unsigned D>
using Wide = boost::multiprecision::number<
    boost::multiprecision::cpp_bin_float<Mp<D>::bits + 64, boost::multiprecision::digit_base_2>,
    boost::multiprecision::et_off>;
template <unsigned D>
Wide<D> wide(const Mp<D>& x) {
  return Wide<D>(number_of(x));
}
template <unsigned D>
MpNumber<D> narrow(const Wide<D>& x) {
  return MpNumber<D>(x);
}

template <unsigned D>
void hypot(Mp<D>& result, const Mp<D>& x, const Mp<D>& y) {
  const Wide<D> a = wide(x), b = wide(y);
  // Infinite even beside no number.
  number_of(result) = isinf(a) || isinf(b) ? std::numeric_limits<MpNumber<D>>::infinity()
                                           : narrow<D>(Wide<D>(sqrt(Wide<D>(a * a + b * b))));
}

template <class F, unsigned D>
F nearest(const Mp<D>& x) {
  return static_cast<F>(number_of(x));
}
template <unsigned D>
std::int64_t exponent(const Mp<D>& x) {
  const auto& number = number_of(x);
  return isfinite(number) && !number.is_zero() ? std::int64_t{number.backend().exponent()} + 1 : Mp<D>::kNoExponent;
}

}  // namespace cageproof::mp_work
