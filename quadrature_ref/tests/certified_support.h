// SPDX-License-Identifier: MIT
// Checks that tests make of enclosures.
#pragma once

#include "cageproof/core/numbers/scalar.h"

namespace cageproof::quadrature_ref {

/// Whether `known` lies in the ball, which must be narrow; `known` carries its own rounding.
inline bool holds(const Mp100& middle, const Mp100& radius, const Mp100& known) {
  const Mp100 rounding("1e-95");
  return radius < Mp100("1e-30") && abs(Mp100(known - middle)) <= radius + rounding;
}

}  // namespace cageproof::quadrature_ref
