// SPDX-License-Identifier: MIT
// The solutions of A w = m in closed form: the null vector of A, and the solution of smallest norm.
#pragma once

#include "quad/mean_value/riemann/mean_vector.h"

namespace cageproof::adaptive_qmvc {

template <class R>
using Vec4 = Eigen::Matrix<R, 4, 1>;

/// kappa of [T18] Eq 26, unnormalised: k_i = (-1)^i det(p_{i+1}, p_{i+2}, p_{i+3}), in cubic units. A kappa = 0; on the
/// quad a multiple of the basis functions; zero where A has rank 2, that is, in the plane of a planar quad.
template <Scalar R>
Vec4<R> null_vector(const PairFrame<R>& s) {
  // det(a, b, c) = a . ((b - a) x (c - a)): of edges, since products of far corners cancel.
  const auto& e = s.along;
  return {s.p[1].dot(e[k12].cross(e[k13])), -s.p[0].dot(e[k02].cross(e[k03])), s.p[0].dot(e[k01].cross(e[k03])),
          -s.p[0].dot(e[k01].cross(e[k02]))};
}

/// The solution of A w = m of smallest norm, [T18] Eq 28 with D = -|kappa|^2: the sign that goes with Eq 26's kappa,
/// whose length must be kept. In units of m over length units. Not finite where kappa is zero.
template <Scalar R>
Vec4<R> minimal_norm_solution(const PairFrame<R>& s, const Vec4<R>& k, const Vec3<R>& m) {
  std::array<R, 6> d;  // det(p_a, p_b, m)
  for (int i = 0; i < 6; ++i) d[i] = s.cross[i].dot(m);
  const R scale = R(-1) / k.squaredNorm();
  return {(k[1] * d[k23] - k[2] * d[k13] + k[3] * d[k12]) * scale,
          (-k[0] * d[k23] + k[2] * d[k03] - k[3] * d[k02]) * scale,
          (k[0] * d[k13] - k[1] * d[k03] + k[3] * d[k01]) * scale,
          (-k[0] * d[k12] + k[1] * d[k02] - k[2] * d[k01]) * scale};
}

/// A w: sum w_i p_i.
template <Scalar R>
Vec3<R> apply(const PairFrame<R>& s, const Vec4<R>& w) {
  return w[0] * s.p[0] + w[1] * s.p[1] + w[2] * s.p[2] + w[3] * s.p[3];
}

}  // namespace cageproof::adaptive_qmvc
