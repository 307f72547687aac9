// SPDX-License-Identifier: MIT
#include "similarities.h"

#include "../nearest_rotation.h"

#include <limits>

namespace cageproof::deformation {
namespace {

// Each row by itself, because a sum of large numbers leaves the range.
template <Scalar R>
Matrix<R> mean_of(const Matrix<R>& rows) {
  return (rows / R(static_cast<double>(rows.rows()))).colwise().sum();
}

}  // namespace

template <Scalar R>
Similarities<R>::Similarities(const Matrix<R>& vertices, Matrix<R> normals)
    : vertices_(vertices),
      from_middle_(vertices.rowwise() - mean_of<R>(vertices).row(0)),
      normals_(std::move(normals)) {
  const Matrix<double> steps = from_middle_.template cast<double>();
  const Eigen::JacobiSVD<Matrix<double>> svd(steps, Eigen::ComputeThinU | Eigen::ComputeThinV);
  frame_ = svd.matrixU() * svd.matrixV().transpose();
  stretch_ = svd.matrixV() * svd.singularValues().asDiagonal() * svd.matrixV().transpose();
}

template <Scalar R>
Similar<R> Similarities<R>::next_to(const Matrix<R>& posed) const {
  // What the pose adds to the cage at rest, because sums of this have smaller roundings than sums of the pose.
  Matrix<R> added = posed - vertices_;
  const Matrix<R> shift = mean_of<R>(added);
  added.rowwise() -= shift.row(0);
  const SpaceMatrix<double> beside_shift = added.template cast<double>().transpose() * frame_;
  Similar<R> found{vertices_.rowwise() + shift.row(0), normals_};
  const double size = stretch_.trace();
  if (!(beside_shift.cwiseAbs().maxCoeff() > std::numeric_limits<double>::epsilon() * size)) return found;
  SpaceMatrix<double> growth = -SpaceMatrix<double>::Identity(stretch_.rows(), stretch_.cols());
  // All to the mean is a similarity, too.
  if (const SpaceMatrix<double> moved = stretch_ + beside_shift; moved.allFinite()) {
    const NearestRotation<double> nearest = nearest_rotation<double>(moved, 0);
    growth += (nearest.signed_values / size).sum() * nearest.rotation;
  }
  const Matrix<R> transposed = growth.transpose().template cast<R>();
  found.vertices += from_middle_ * transposed;
  found.normals += normals_ * transposed;
  return found;
}

template class Similarities<double>;
template class Similarities<Mp50>;

}  // namespace cageproof::deformation
