// SPDX-License-Identifier: MIT
// Vectors over the scalars that formulas are evaluated in.
#pragma once

#include "cageproof/core/scalar.h"
#include "cageproof/core/vector.h"

namespace cageproof {

/// The same point in another scalar; exact when To is wider than From.
template <Scalar To, Scalar From>
Vec3<To> convert(const Vec3<From>& v) {
  return {static_cast<To>(v[0]), static_cast<To>(v[1]), static_cast<To>(v[2])};
}

}  // namespace cageproof
