// SPDX-License-Identifier: MIT
// The similarity next to a pose.
#pragma once

#include "cageproof/core/numbers/least_squares.h"

namespace cageproof::deformation {

/// Images of a cage's vertices and normal derivatives under a similarity, one row each.
template <Scalar R>
struct Similar {
  Matrix<R> vertices, normals;
};

/// Similarities of one cage. Found in double for any R, because only what a pose has beside one depends on which it is.
template <Scalar R>
class Similarities {
 public:
  Similarities() = default;
  /// \param vertices of the cage at rest, one row each \param normals of its elements or corners, one row each
  Similarities(const Matrix<R>& vertices, Matrix<R> normals);

  /// A similarity next to a pose: exactly a shift where the pose is one up to its roundings.
  Similar<R> next_to(const Matrix<R>& posed) const;

 private:
  Matrix<R> vertices_, from_middle_, normals_;
  // Steps from the middle are frame_ times stretch_, whose columns are of length one and at right angles, and which is
  // symmetric. A pose that turns and scales by Q has frame_ times stretch_ times Q's transpose, so that it is found as
  // well from a rod as from a ball, where products of steps with steps would leave half as many digits of thin sides.
  Matrix<double> frame_, stretch_;
};

}  // namespace cageproof::deformation
