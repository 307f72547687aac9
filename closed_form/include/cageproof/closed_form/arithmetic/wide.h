// SPDX-License-Identifier: MIT
// Twice the working precision for the few quantities whose sign and relative size must survive cancellation.
#pragma once

#include "cageproof/closed_form/arithmetic/double_double.h"
#include "cageproof/core/numbers/linear.h"

#include <array>
#include <type_traits>

namespace cageproof::closed_form {

/// The type with at least twice R's digits that frames are computed in; multiprecision needs none.
template <Scalar R>
using Wide =
    std::conditional_t<std::same_as<R, float>, double, std::conditional_t<std::same_as<R, double>, DoubleDouble, R>>;

/// Three numbers of a Wide type: only what frames need of a vector.
template <class W>
struct WideVec {
  std::array<W, 3> c;
  const W& operator[](int i) const { return c[i]; }
  friend WideVec cross(const WideVec& a, const WideVec& b) {
    return {{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]}};
  }
  friend W dot(const WideVec& a, const WideVec& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
};

/// a - b, exact for float and double.
template <Scalar R>
WideVec<Wide<R>> wide_difference(const Vec3<R>& a, const Vec3<R>& b) {
  WideVec<Wide<R>> v;
  for (int i = 0; i < 3; ++i) {
    if constexpr (std::same_as<R, double>) v.c[i] = DoubleDouble::sum(a[i], -b[i]);
    else v.c[i] = Wide<R>(a[i]) - Wide<R>(b[i]);
  }
  return v;
}

template <Scalar R>
Vec3<R> narrow(const WideVec<Wide<R>>& v) {
  return {static_cast<R>(v[0]), static_cast<R>(v[1]), static_cast<R>(v[2])};
}

}  // namespace cageproof::closed_form
