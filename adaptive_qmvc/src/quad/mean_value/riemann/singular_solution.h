// SPDX-License-Identifier: MIT
// The solutions of A w = m from the singular values of A: what linear_solution.h has in closed form.
#pragma once

#include "quad/mean_value/riemann/linear_solution.h"

#include <Eigen/SVD>

namespace cageproof::adaptive_qmvc {

/// The null vector of A and the solution of smallest norm from the singular value decomposition ([T18] Eq 18 and 20).
template <Scalar R>
struct SingularSolution {
  Vec4<R> null_vector;  ///< of length 1, of either sign
  Vec4<R> minimal_norm;
};

template <Scalar R>
SingularSolution<R> singular_solution(const PairFrame<R>& s, const Vec3<R>& m) {
  // Square with a row of zeros, which asks Eigen for no decomposition before its own.
  using Square = Eigen::Matrix<R, 4, 4>;
  Square a = Square::Zero();
  for (int i = 0; i < 4; ++i) a.template block<3, 1>(0, i) = s.p[i];
  const Eigen::JacobiSVD<Square, Eigen::NoQRPreconditioner> svd(a, Eigen::ComputeFullU | Eigen::ComputeFullV);
  Vec4<R> w = Vec4<R>::Zero();
  for (int i = 0; i < 3; ++i) {
    const R along = R(svd.matrixU().col(i).template head<3>().dot(m)) / svd.singularValues()[i];
    w += along * Vec4<R>(svd.matrixV().col(i));
  }
  return {svd.matrixV().col(3), w};
}

}  // namespace cageproof::adaptive_qmvc
