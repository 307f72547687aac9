// SPDX-License-Identifier: MIT
// What closed forms on a segment are templates over: the scalars of formulas, and doubles that bound their own error.
#pragma once

#include "cageproof/closed_form/arithmetic/constants.h"
#include "cageproof/closed_form/arithmetic/names.h"
#include "cageproof/core/scalar_names.h"

namespace cageproof::closed_form::segment {

/// In this folder a scalar is also a double that carries a bound of its own error.
template <class R>
concept Scalar = cageproof::Scalar<R> || std::same_as<R, Tracked<double>>;

template <Scalar R>
R unit_roundoff() {
  if constexpr (is_tracked<R>) return R(cageproof::unit_roundoff<double>());
  else return cageproof::unit_roundoff<R>();
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
