// SPDX-License-Identifier: MIT
// Vectors and matrices in as many dimensions as the space has.
#pragma once

#include "cageproof/core/numbers/linear.h"

#include <Eigen/LU>

namespace cageproof::deformation {

template <Scalar R>
using SpaceVector = Eigen::Matrix<R, Eigen::Dynamic, 1, Eigen::ColMajor, 3, 1>;
template <Scalar R>
using SpaceMatrix = Eigen::Matrix<R, Eigen::Dynamic, Eigen::Dynamic, Eigen::ColMajor, 3, 3>;

template <Scalar R>
SpaceVector<R> in(int dimension, const Vec3<R>& v) {
  return v.head(dimension);
}

/// The same map of three dimensions, which keeps those that the space has not.
template <Scalar R>
Mat3<R> in_three(const SpaceMatrix<R>& matrix) {
  Mat3<R> found = Mat3<R>::Identity();
  found.topLeftCorner(matrix.rows(), matrix.cols()) = matrix;
  return found;
}

/// A square matrix's factors. Eigen's for three dimensions are a fraction of those for any to compile.
template <Scalar R>
class SpaceSolver {
 public:
  explicit SpaceSolver(const SpaceMatrix<R>& matrix) : dimension_(matrix.rows()), factors_(in_three<R>(matrix)) {}

  SpaceVector<R> solve(const SpaceVector<R>& right) const {
    Vec3<R> whole = Vec3<R>::Zero();
    whole.head(dimension_) = right;
    const Vec3<R> found = factors_.solve(whole);
    return found.head(dimension_);
  }
  SpaceMatrix<R> inverse() const {
    const Mat3<R> found = factors_.solve(Mat3<R>::Identity());
    return found.topLeftCorner(dimension_, dimension_);
  }

 private:
  Eigen::Index dimension_;
  Eigen::PartialPivLU<Mat3<R>> factors_;
};

}  // namespace cageproof::deformation
