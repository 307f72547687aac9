// SPDX-License-Identifier: MIT
// Sums of squared singular values of thin elements' maps.
#pragma once

#include "cageproof/core/numbers/linear.h"

#include <array>
#include <cmath>

namespace cageproof::deformation {

/// area^2 (s1^2 + s2^2) of the singular values of the linear map that takes `from` to `to`, as the sum of two squares:
/// of the longer tangent's image, and of the image of what the other has across it. With the Gram matrices of both it
/// is trace(adj(g) h), whose terms are as large as products of squared lengths, and cancel where tangents are next to
/// in line; here they cancel before they are squared. \param area |from[0] x from[1]|
template <Scalar R>
R stretched_squares(const std::array<Vec3<R>, 2>& from, const std::array<Vec3<R>, 2>& to, const R& area) {
  using std::sqrt;
  const R squares[2] = {from[0].dot(from[0]), from[1].dot(from[1])};
  const int first = squares[1] > squares[0] ? 1 : 0;
  const R& square = squares[first];
  if (!(square > 0)) return R(0);
  const R length = sqrt(square), along = from[0].dot(from[1]) / length, across = area / length;
  const Vec3<R> of_other = length * to[1 - first] - along * to[first];
  return of_other.dot(of_other) + across * across * to[first].dot(to[first]);
}

}  // namespace cageproof::deformation
