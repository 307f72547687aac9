// SPDX-License-Identifier: MIT
// The rotation nearest to a matrix.
#pragma once

#include "in_space.h"

#include <Eigen/SVD>

namespace cageproof::deformation {

template <Scalar R>
struct NearestRotation {
  SpaceMatrix<R> rotation;
  SpaceVector<R> signed_values;  ///< singular values, the last with the determinant's sign
  bool is_unique;
};

/// U diag(1, ..., det(U W^t)) W^t of a square matrix U S W^t, nearest in the Frobenius norm (Umeyama 1991).
/// \param tolerance of the largest singular value: smaller values, and smaller differences, count as zero
template <Scalar R>
NearestRotation<R> nearest_rotation(const SpaceMatrix<R>& matrix, const R& tolerance) {
  // A square matrix is taken as it is.
  const Eigen::JacobiSVD<SpaceMatrix<R>, Eigen::NoQRPreconditioner> svd(matrix,
                                                                        Eigen::ComputeFullU | Eigen::ComputeFullV);
  const Eigen::Index last = matrix.rows() - 1;
  SpaceVector<R> signs = SpaceVector<R>::Ones(matrix.rows());
  const R determinant = in_three<R>(svd.matrixU() * svd.matrixV().transpose()).determinant();
  if (determinant < 0) signs[last] = -1;
  const SpaceVector<R>& values = svd.singularValues();
  const R small = tolerance * values[0];
  const bool unique = values[last - 1] > small && !(determinant < 0 && values[last - 1] - values[last] <= small);
  return {svd.matrixU() * signs.asDiagonal() * svd.matrixV().transpose(), values.cwiseProduct(signs), unique};
}

}  // namespace cageproof::deformation
