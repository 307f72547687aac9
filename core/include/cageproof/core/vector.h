// SPDX-License-Identifier: MIT
// Fixed-size vectors and matrices over any number type, without the multiprecision types themselves.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace cageproof {

/// A point or vector. In the plane the third coordinate is zero.
template <class R>
using Vec3 = Eigen::Matrix<R, 3, 1>;
template <class R>
using Mat3 = Eigen::Matrix<R, 3, 3>;

}  // namespace cageproof
