// SPDX-License-Identifier: MIT
// The angle omega_t and its derivatives, which most of [T24] is built from: Appendix A and Section 3.1.
#pragma once

#include "cageproof/closed_form/published/misprint.h"
#include "published/triangle/engine/frame.h"

namespace cageproof::closed_form::published {

/// [T24] Appendix A: gamma_0 + gamma_1 - acos(d C_0/sqrt(d^2 + a^2)) - acos(d C_1/sqrt(d^2 + a^2)) of the subtriangle
/// (p, e0, e1), with delta_i C_i = epsilon_i zeta_i and delta_i S_i = a (Eq 59, 61). It is minus the subtriangle's
/// solid angle. \pre the point does not project onto the edge's line
template <Scalar R>
R subtriangle_angle(const Edge<R>& e, const R& unsigned_d) {
  using std::abs, std::acos, std::atan2, std::sqrt;
  const R a = abs(e.a);
  const R root = sqrt(unsigned_d * unsigned_d + a * a);
  R angle(0);
  for (int i = 0; i < 2; ++i) {
    const R dc = i == 0 ? e.zeta[0] : R(-e.zeta[1]);  // delta_i C_i
    const R delta = sqrt(a * a + dc * dc);
    angle += atan2(a, dc) - acos(unsigned_d * (dc / delta) / root);
  }
  return angle;
}

/// omega_t = int x.n/r^3 in radians, positive where d_t < 0: the sign that Eq 10-14 need. In the plane, the limit from
/// inside. It cancels far away.
template <Scalar R>
R omega(const Frame<R>& s, Misprint misprint) {
  using std::abs;
  R sum(0);
  for (const Edge<R>& e : s.edges) {
    if (e.a == 0) continue;  // an empty subtriangle has no angles
    const R angle = subtriangle_angle(e, R(abs(s.d)));
    sum += e.a > 0 ? angle : R(-angle);
  }
  if (s.d <= 0) sum = -sum;
  // "omega_t has the same sign as d_t"
  return misprint == Misprint::AppendixA ? R(-sum) : sum;
}

/// grad omega_t, 1/length ([T24] after Eq 12). Not finite on the edges.
template <Scalar R>
Vec3<R> omega_gradient(const Frame<R>& s) {
  Vec3<R> sum = Vec3<R>::Zero();
  for (const Edge<R>& e : s.edges) sum += 2 * (e.l[0] + e.l[1]) / e.q() * e.unit(0).cross(e.unit(1));
  return sum;
}

/// H(omega_t), 1/area ([T24] after Eq 14). Not finite on the edges.
template <Scalar R>
Mat3<R> omega_hessian(const Frame<R>& s) {
  Mat3<R> sum = Mat3<R>::Zero();
  for (const Edge<R>& e : s.edges) {
    const Vec3<R> normal = e.unit(1).cross(e.unit(0));
    const R together = e.l[0] + e.l[1], less = together - e.length, more = together + e.length;
    sum += together / (e.q() * e.l[0] * e.l[1]) * tensor<R>(normal, e.l[0] * e.unit(1) + e.l[1] * e.unit(0));
    sum += (1 / (2 * less * less) + 1 / (2 * more * more)) * tensor<R>(normal, e.unit(1) + e.unit(0));
  }
  return sum;
}

}  // namespace cageproof::closed_form::published
