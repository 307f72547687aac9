// SPDX-License-Identifier: MIT
// The derivatives of nearest rotations, and of tangents.
#pragma once

#include "nearest_rotation.h"

#include "cageproof/core/input_error.h"

#include <fmt/format.h>

#include <array>
#include <string>

namespace cageproof::deformation {

/// The rotation Q nearest to M, and the rotation vector of its change along dM. With S = Q^t M, which is symmetric, and
/// dQ = Q W, the antisymmetric part of Q^t dM = W S + dS says that (tr S - S) w is its axial vector.
template <Scalar R>
class RotationSlope {
 public:
  RotationSlope(int dimension, const Mat3<R>& matrix, const std::string& whose) {
    const NearestRotation<R> nearest =
        nearest_rotation<R>(matrix.topLeftCorner(dimension, dimension), 64 * unit_roundoff<R>());
    if (!nearest.is_unique)
      throw InputError(fmt::format("the rotation of {} is not unique, and has no derivative", whose));
    rotation_ = in_three<R>(nearest.rotation);
    const Mat3<R> stretch = rotation_.transpose() * matrix;
    factors_.compute(Mat3<R>(stretch.trace() * Mat3<R>::Identity() - (stretch + stretch.transpose()) / R(2)));
  }

  const Mat3<R>& rotation() const { return rotation_; }
  Vec3<R> of(const Mat3<R>& change) const {
    const Mat3<R> a = rotation_.transpose() * change;
    return rotation_ * factors_.solve(Vec3<R>(a(2, 1) - a(1, 2), a(0, 2) - a(2, 0), a(1, 0) - a(0, 1)));
  }

 private:
  Mat3<R> rotation_;
  Eigen::PartialPivLU<Mat3<R>> factors_;
};

/// Each corner's weights in the two tangents (tangents_of).
template <Scalar R>
std::array<std::array<R, 2>, 4> tangent_weights(std::size_t corners, int corner) {
  std::array<std::array<R, 2>, 4> found;
  for (auto& pair : found) pair.fill(R(0));
  if (corners < 4) {
    found[0] = {R(-1), R(-1)};
    found[1][0] = found[2][1] = R(1);
    return found;
  }
  const R third = R(1) / 3;
  found[corner] = {-2 * third, -2 * third};
  found[(corner + 1) % 4] = {2 * third, -third};
  found[(corner + 2) % 4] = {third, third};
  found[(corner + 3) % 4] = {-third, 2 * third};
  return found;
}

}  // namespace cageproof::deformation
