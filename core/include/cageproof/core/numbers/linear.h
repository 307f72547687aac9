// SPDX-License-Identifier: MIT
// Vectors over the scalars that formulas are evaluated in.
#pragma once

#include "cageproof/core/numbers/scalar.h"
#include "cageproof/core/numbers/vector.h"

/// The traits that Eigen needs of a number type.
template <unsigned Digits>
struct Eigen::NumTraits<cageproof::Mp<Digits>> {
  using Real = cageproof::Mp<Digits>;
  using NonInteger = Real;
  using Literal = Real;
  using Nested = Real;
  enum {
    IsComplex = 0,
    IsInteger = 0,
    IsSigned = 1,
    RequireInitialization = 1,
    ReadCost = 20,
    AddCost = 30,
    MulCost = 40
  };
  static Real epsilon() { return std::numeric_limits<Real>::epsilon(); }
  static Real dummy_precision() { return 1000 * epsilon(); }
  static Real highest() { return (std::numeric_limits<Real>::max)(); }
  static Real lowest() { return std::numeric_limits<Real>::lowest(); }
  static Real infinity() { return std::numeric_limits<Real>::infinity(); }
  static Real quiet_NaN() { return std::numeric_limits<Real>::quiet_NaN(); }
  static constexpr int digits10() { return std::numeric_limits<Real>::digits10; }
};

namespace cageproof {

/// The same point in another scalar; exact when To is wider than From.
template <Scalar To, Scalar From>
Vec3<To> convert(const Vec3<From>& v) {
  return {static_cast<To>(v[0]), static_cast<To>(v[1]), static_cast<To>(v[2])};
}

}  // namespace cageproof
