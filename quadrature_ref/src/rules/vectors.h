// SPDX-License-Identifier: MIT
// Products of vectors in the order of operations that all rules share.
#pragma once

#include "cageproof/core/numbers/linear.h"

#include <cmath>

namespace cageproof::quadrature_ref {

template <Scalar R>
R dot(const Vec3<R>& a, const Vec3<R>& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

template <Scalar R>
R length(const Vec3<R>& a) {
  using std::sqrt;
  return sqrt(dot(a, a));
}

}  // namespace cageproof::quadrature_ref
