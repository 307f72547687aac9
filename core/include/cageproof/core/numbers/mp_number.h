// SPDX-License-Identifier: MIT
// Access to the Boost.Multiprecision number inside a multiprecision scalar, for code that needs Boost's own functions.
#pragma once

#include "cageproof/core/numbers/mp.h"

#ifdef CAGEPROOF_NO_MPFR
#include <boost/multiprecision/cpp_bin_float.hpp>
#else
#include <boost/multiprecision/mpfr.hpp>
#endif

#include <new>

namespace cageproof {

/// MPFR or Boost's own, stored in place, expression templates off.
#ifdef CAGEPROOF_NO_MPFR
template <unsigned Digits>
using MpNumber = boost::multiprecision::number<
    boost::multiprecision::cpp_bin_float<Mp<Digits>::bits, boost::multiprecision::digit_base_2>,
    boost::multiprecision::et_off>;
#else
template <unsigned Digits>
using MpNumber = boost::multiprecision::number<
    boost::multiprecision::mpfr_float_backend<Digits, boost::multiprecision::allocate_stack>,
    boost::multiprecision::et_off>;
#endif

/// The number as Boost's.
template <unsigned D>
const MpNumber<D>& number_of(const Mp<D>& x) {
  return *std::launder(static_cast<const MpNumber<D>*>(x.number()));
}
template <unsigned D>
MpNumber<D>& number_of(Mp<D>& x) {
  return *std::launder(static_cast<MpNumber<D>*>(x.number()));
}

/// Boost's number as ours.
template <unsigned D>
Mp<D> from_number(const MpNumber<D>& x) {
  Mp<D> result;
  number_of(result) = x;
  return result;
}

/// The type that Boost's functions take for a scalar, and what converts to it and back.
template <class R>
struct BoostReal {
  using Number = R;
  static const R& to(const R& x) { return x; }
  static const R& from(const R& x) { return x; }
};
template <unsigned D>
struct BoostReal<Mp<D>> {
  using Number = MpNumber<D>;
  static const Number& to(const Mp<D>& x) { return number_of(x); }
  static Mp<D> from(const Number& x) { return from_number(x); }
};

}  // namespace cageproof
