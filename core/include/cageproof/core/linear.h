// SPDX-License-Identifier: MIT
// Fixed-size vectors and matrices over any scalar.
#pragma once

#include "cageproof/core/scalar.h"

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace cageproof {

template <class R>
using Vec3 = Eigen::Matrix<R, 3, 1>;
template <class R>
using Mat3 = Eigen::Matrix<R, 3, 3>;

/// The same point in another scalar; exact when To is wider than From.
template <Scalar To, Scalar From>
Vec3<To> convert(const Vec3<From>& v) {
  return {static_cast<To>(v[0]), static_cast<To>(v[1]), static_cast<To>(v[2])};
}

}  // namespace cageproof
