// SPDX-License-Identifier: MIT
// Constants in the type that a form is computed in.
#pragma once

#include "cageproof/core/numbers/scalar_names.h"

namespace cageproof::closed_form {

/// The ratio of a circle's circumference to its diameter, rounded to R, which is a scalar or has a `pi` of its own.
template <class R>
R constant_pi() {
  if constexpr (Scalar<R>) return pi<R>();
  else return R::pi();
}

}  // namespace cageproof::closed_form
