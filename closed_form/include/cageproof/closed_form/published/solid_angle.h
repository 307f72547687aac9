// SPDX-License-Identifier: MIT
// The solid angle as [T24] Appendix A and Section 3.1 print it.
#pragma once

#include "cageproof/closed_form/published/misprint.h"
#include "cageproof/closed_form/published/notation.h"

namespace cageproof::closed_form::published {

/// [T24] Appendix A: gamma_0 + gamma_1 - acos(d C_0/sqrt(d^2 + a^2)) - acos(d C_1/sqrt(d^2 + a^2)) of the subtriangle
/// (p, e0, e1), with delta_i C_i = epsilon_i zeta_i and delta_i S_i = a (Eq 59, 61). It is minus the subtriangle's solid angle.
/// \pre the point does not project onto the edge's line
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

/// omega_t = int x.n/r^3, positive where d_t < 0: the sign that Eq 10-14 need. In the plane, the limit from inside.
template <Scalar R>
R omega(const Setting<R>& s, Misprint misprint) {
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

/// grad omega_t ([T24] after Eq 12).
template <Scalar R>
Vec3<R> omega_gradient(const Setting<R>& s) {
  Vec3<R> sum = Vec3<R>::Zero();
  for (const Edge<R>& e : s.edges) sum += 2 * (e.l[0] + e.l[1]) / e.q() * e.unit(0).cross(e.unit(1));
  return sum;
}

/// H(omega_t) ([T24] after Eq 14).
template <Scalar R>
Mat3<R> omega_hessian(const Setting<R>& s) {
  Mat3<R> sum = Mat3<R>::Zero();
  for (const Edge<R>& e : s.edges) {
    const Vec3<R> normal = e.unit(1).cross(e.unit(0));
    const R together = e.l[0] + e.l[1], less = together - e.length, more = together + e.length;
    sum += together / (e.q() * e.l[0] * e.l[1]) * tensor<R>(normal, e.l[0] * e.unit(1) + e.l[1] * e.unit(0));
    sum += (1 / (2 * less * less) + 1 / (2 * more * more)) * tensor<R>(normal, e.unit(1) + e.unit(0));
  }
  return sum;
}

/// omega_t with its derivatives. \param order 0, 1 or 2
template <Scalar R>
Jet<R, 1> solid_angle(const Setting<R>& s, int order, Misprint misprint) {
  Jet<R, 1> jet;
  jet.value[0] = omega(s, misprint);
  if (order >= 1) jet.gradient[0] = omega_gradient(s);
  if (order >= 2) jet.hessian[0] = omega_hessian(s);
  return jet;
}

}  // namespace cageproof::closed_form::published
