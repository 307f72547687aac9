// SPDX-License-Identifier: MIT
// Template arguments of closed forms on a segment: the scalars of formulas, and numbers that bound their own error.
#pragma once

#include "cageproof/closed_form/arithmetic/constants.h"
#include "cageproof/closed_form/arithmetic/names.h"
#include "cageproof/core/numbers/scalar_names.h"

namespace cageproof::closed_form::segment {

/// In this folder a scalar is also a number that carries a bound of its own error.
template <class R>
concept Scalar = cageproof::Scalar<R> || is_tracked<R>;

/// Whether exponents do not overflow.
template <class R>
inline constexpr bool is_wide = is_multiprecision<R>;
template <class T>
inline constexpr bool is_wide<Tracked<T>> = is_multiprecision<T>;

/// A number given by the caller; tracked ones of multiprecision may have fewer digits.
template <Scalar R, class P>
R number_from(const P& x) {
  if constexpr (is_tracked<R> && is_multiprecision<P>) return R::rounded(decltype(R::value)(x), 0);
  else return R(x);
}
template <Scalar R>
R pi() {
  return constant_pi<R>();
}
template <Scalar R>
R ln_two() {
  if constexpr (is_tracked<R>) return R::ln_two();
  else return cageproof::ln_two<R>();
}

}  // namespace cageproof::closed_form::segment
