// SPDX-License-Identifier: MIT
// The integral of the distance over a triangle, its gradient and Hessian: [T24] Eq 10, 12, 14. Next to an edge or a
// corner, and far away, the printed terms cancel, and on lines that no branch catches they are 0/0: results there are
// wrong or not finite in double.
#pragma once

#include "published/triangle/engine/omega.h"

namespace cageproof::closed_form::published {

/// int_t r, a volume ([T24] Eq 10). Edges on whose line the point lies exactly drop out.
template <Scalar R>
R distance_integral(const Frame<R>& s, Misprint misprint) {
  const R d2 = s.d * s.d;
  R sum = s.in_plane ? R(0) : R(d2 * s.d * omega(s, misprint) / 3);
  for (const Edge<R>& e : s.edges) {
    if (e.on_line) continue;
    sum += e.a / 6 * ((2 * d2 + e.D2) * e.log_ratio() - e.l[1] * e.zeta[1] + e.l[0] * e.zeta[0]);
  }
  return sum;
}

/// Gradient of int_t r, an area ([T24] Eq 12). Of edges on whose line the point lies exactly the blue terms remain.
template <Scalar R>
Vec3<R> distance_integral_gradient(const Frame<R>& s, Misprint misprint) {
  const R d = s.d, d2 = d * d;
  Vec3<R> sum = Vec3<R>::Zero();
  if (!s.in_plane) sum = d2 * omega(s, misprint) * s.n + d2 * d / 3 * omega_gradient(s);
  for (const Edge<R>& e : s.edges) {
    sum += e.r / 6 * (e.l[0] * e.zeta[0] - e.l[1] * e.zeta[1]);  // blue
    if (e.on_line) continue;
    const R log_ratio = e.log_ratio(), w = 2 * d2 + e.D2;
    sum += e.r / 6 * w * log_ratio;
    sum += e.a / 6 * (4 * d * s.n + 2 * e.D) * log_ratio;
    sum += e.a / 6 * w * (e.m(1) - e.m(0));
    sum += e.a / 6 * (e.unit(0) * e.zeta[0] - e.unit(1) * e.zeta[1] + (e.l[0] - e.l[1]) * e.u);
  }
  return sum;
}

/// Hessian of int_t r, a length ([T24] Eq 14). Of edges on whose line the point lies exactly the blue terms remain.
template <Scalar R>
Mat3<R> distance_integral_hessian(const Frame<R>& s, Misprint misprint) {
  const R d = s.d, d2 = d * d;
  Mat3<R> sum = Mat3<R>::Zero();
  if (!s.in_plane) {
    sum += d * omega(s, misprint) * tensor<R>(s.n, s.n) + d2 * tensor<R>(s.n, omega_gradient(s));
    sum += d2 * d / 3 * omega_hessian(s);
  }
  for (const Edge<R>& e : s.edges) {
    sum += tensor<R>(e.r, e.unit_zeta(0) - e.unit_zeta(1) + (e.l[0] - e.l[1]) * e.u) / 6;  // blue
    if (e.on_line) continue;
    const R log_ratio = e.log_ratio();
    sum += log_ratio / 6 * tensor<R>(e.r, 4 * d * s.n + 2 * e.D);
    sum += e.a / 6 * log_ratio * (4 * s.n * s.n.transpose() + 2 * e.P());
    sum += tensor<R>(6 * e.a * d * s.n + 3 * e.D2 * e.r, e.m(1) - e.m(0)) / 6;
    sum += e.a / 6 * (e.zeta[0] * e.U(0) - e.zeta[1] * e.U(1) + tensor<R>(e.unit(0) - e.unit(1), e.u));
    sum += e.a / 6 * (2 * d2 + e.D2) * (e.M(1) - e.M(0));
  }
  return sum;
}

}  // namespace cageproof::closed_form::published
