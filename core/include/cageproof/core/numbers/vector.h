// SPDX-License-Identifier: MIT
// Fixed-size vectors, matrices and corners over any number type, without the multiprecision types themselves.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <array>

namespace cageproof {

/// A point or vector. In the plane the third coordinate is zero.
template <class R>
using Vec3 = Eigen::Matrix<R, 3, 1>;
template <class R>
using Mat3 = Eigen::Matrix<R, 3, 3>;

/// The corners of an element, in the order of ElementKind.
template <class R>
using Segment = std::array<Vec3<R>, 2>;
template <class R>
using Triangle = std::array<Vec3<R>, 3>;
template <class R>
using Quad = std::array<Vec3<R>, 4>;

}  // namespace cageproof
