// SPDX-License-Identifier: MIT
// Quad mean value weights from triangles in the quad's place: the baseline of [T18] Section 2.3.
#pragma once

#include "cageproof/adaptive_qmvc/kernel_solution.h"
#include "cageproof/closed_form/triangle/triangle_form.h"

#include <limits>

namespace cageproof::adaptive_qmvc {

/// The basis functions of corners 0..3 ([T18] Eq 3).
template <class R>
Vec4<R> bilinear_basis(const R& u, const R& v) {
  return {(1 - u) * (1 - v), u * (1 - v), u * v, (1 - u) * v};
}

template <class R>
Vec3<R> surface_point(const Quad<R>& q, const Vec4<R>& basis) {
  return basis[0] * q[0] + basis[1] * q[1] + basis[2] * q[2] + basis[3] * q[3];
}

/// The weights of n x n sub-quads, each cut from its corner 0 to its corner 2, with basis functions linear on each
/// triangle. On a triangle they diverge:
/// infinite for the corners whose interpolated basis function is positive there, zero for the others.
template <Scalar R>
Vec4<R> tessellated_weights(const Quad<R>& q, const Vec3<R>& point, int n) {
  Vec4<R> sum = Vec4<R>::Zero(), diverging = Vec4<R>::Zero();
  bool diverges = false;
  const auto add_triangle = [&](const std::array<Vec4<R>, 3>& basis) {
    const Triangle<R> t{surface_point(q, basis[0]), surface_point(q, basis[1]), surface_point(q, basis[2])};
    const auto w = closed_form::closed_form<closed_form::MeanValue, 0, R>(t, point, {}).value;
    for (int c = 0; c < 3; ++c) {
      const bool infinite = w[c] == std::numeric_limits<R>::infinity();
      (infinite ? diverging : sum) += basis[c] * (infinite ? R(1) : w[c]);
      diverges = diverges || infinite;
    }
  };
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) {
      const auto basis = [&](int a, int b) { return bilinear_basis<R>(R(i + a) / R(n), R(j + b) / R(n)); };
      add_triangle({basis(0, 0), basis(1, 0), basis(1, 1)});
      add_triangle({basis(0, 0), basis(1, 1), basis(0, 1)});
    }
  if (!diverges) return sum;
  for (int k = 0; k < 4; ++k) sum[k] = diverging[k] > 0 ? std::numeric_limits<R>::infinity() : R(0);
  return sum;
}

}  // namespace cageproof::adaptive_qmvc
