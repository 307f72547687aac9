// SPDX-License-Identifier: MIT
#pragma once

#include "cageproof/closed_form/triangle/finish.h"
#include "cageproof/closed_form/triangle/frame.h"

namespace cageproof::closed_form {

/// Integrals over one edge of even powers of r: the edge form of the mean vector of [T18] Eq 13.
template <Scalar R>
struct EvenIntegrals {
  R K2;              ///< 1/r^2: the edge's angle over its line's distance
  R K4, S4;          ///< 1/r^4, s/r^4
  R K6, S6, SS6;     ///< 1/r^6, s/r^6, s^2/r^6
  R in_plane_rest;   ///< h times the integral of 1/(r^2 rho^2), rho the distance from the point's projection

  EvenIntegrals(const FrameEdge<R>& e, const R& d, int order) {
    using std::abs, std::atan2, std::sqrt;
    const R across = sqrt(e.D2);
    const R product = e.s0 * e.s1;
    K2 = across == 0 ? R(e.length / product) : R(atan2(e.length * across, e.D2 + product) / across);
    // Two angles' difference is taken as one angle, which leaves no small divisor.
    const R reach = abs(e.h);
    const R angle = atan2(e.length * reach, reach * reach + product);
    const R step = d * d / (across + reach);
    const R turn = atan2(e.length * step * (reach * across - product),
                         (reach * reach + product) * (e.D2 + product) + e.length * e.length * reach * across);
    const R sign = e.h < 0 ? R(-1) : R(1);
    in_plane_rest = sign * (angle * step + reach * turn) / (across * d * d);
    if (order < 1) return;
    const R q0 = 1 / (e.r0 * e.r0), q1 = 1 / (e.r1 * e.r1);
    const R difference = e.length * (e.s0 + e.s1) * q0 * q1;  // 1/r0^2 - 1/r1^2
    S4 = difference / 2;
    if (across == 0) {
      // On the line beyond the ends r is the arc length itself.
      K4 = abs(e.r1 * q1 * q1 - e.r0 * q0 * q0) / 3;
      K6 = abs(e.r1 * q1 * q1 * q1 - e.r0 * q0 * q0 * q0) / 5;
    } else {
      K4 = (e.s1 * q1 - e.s0 * q0 + K2) / (2 * e.D2);
      K6 = (e.s1 * q1 * q1 - e.s0 * q0 * q0 + 3 * K4) / (4 * e.D2);
    }
    S6 = difference * (q0 + q1) / 4;
    SS6 = K4 - e.D2 * K6;
  }
  Vec3<R> gradient_K2(const FrameEdge<R>& e) const { return 2 * (S4 * e.u + K4 * e.D); }
  Vec3<R> gradient_K4(const FrameEdge<R>& e) const { return 4 * (S6 * e.u + K6 * e.D); }
  Mat3<R> hessian_K2(const FrameEdge<R>& e) const {
    return -2 * K4 * Mat3<R>::Identity() + 8 * SS6 * e.u * e.u.transpose() + 8 * S6 * symmetric_outer<R>(e.u, e.D) +
           8 * K6 * e.D * e.D.transpose();
  }
};

/// The weights in the triangle's plane, outside it: zero, with w_k = d Y_k and Y_k = (G_k + Gamma_k sum h K4)/2 nearby.
template <Scalar R>
Jet<R, 3> mean_value_in_plane(const Frame<R>& f) {
  Jet<R, 3> jet;
  R hK4 = 0;
  Vec3<R> grad_hK4 = Vec3<R>::Zero();
  std::array<Vec3<R>, 3> grad_K2;
  std::array<R, 3> K2;
  for (int i = 0; i < 3; ++i) {
    const FrameEdge<R>& e = f.edges[i];
    const EvenIntegrals<R> even(e, R(0), 1);
    K2[i] = even.K2;
    grad_K2[i] = even.gradient_K2(e);
    hK4 += e.h * even.K4;
    grad_hK4 += e.h * even.gradient_K4(e) - even.K4 * e.nu;
  }
  for (int k = 0; k < 3; ++k) {
    const Vec3<R> g = f.hat_gradient(k);
    const R gamma = f.hat(k);
    R Y = gamma * hK4;
    Vec3<R> grad_Y = hK4 * g + gamma * grad_hK4;
    for (int i = 0; i < 3; ++i) {
      const R weight = f.edges[i].nu.dot(g);
      Y += weight * K2[i];
      grad_Y += weight * grad_K2[i];
    }
    jet.gradient[k] = (Y / 2) * f.n;
    jet.hessian[k] = symmetric_outer<R>(f.n, grad_Y) / 2;
  }
  return jet;
}

/// w_t^k = int_t Gamma_k x.n/r^4, the unnormalised mean value weights ([T18] Eq 11; equal to Eq 12-14): 1/length; gradient 1/length^2;
/// Hessian 1/length^3. With d the height, F = sum h K2 and G_k = sum (nu.g_k) K2 over the edges, w_k = (d G_k - Gamma_k F/d)/2.
/// On the triangle the weights diverge: they are infinite where the hat function is positive, and their ratios tend to the hat functions
/// (derivatives: NaN). In the plane outside it they are zero, their derivatives are not.
/// Next to the plane the quotient F/d loses digits in the derivatives, not in the value.
template <Scalar R>
Jet<R, 3> mean_value(const Triangle<R>& t, const Vec3<R>& eta, int order) {
  const Frame<R> f(t, eta);
  if (f.d == 0 && !f.on_triangle()) return finish(mean_value_in_plane(f), -1, f.unit);
  Jet<R, 3> jet;
  if (f.d == 0) {
    for (int k = 0; k < 3; ++k)
      if (f.hat(k) > 0) jet.value[k] = std::numeric_limits<R>::infinity();
    return finish(jet, -1, f.unit, 1);
  }
  const std::array<EvenIntegrals<R>, 3> even{EvenIntegrals<R>(f.edges[0], f.d, order),
                                             EvenIntegrals<R>(f.edges[1], f.d, order),
                                             EvenIntegrals<R>(f.edges[2], f.d, order)};
  R F = 0, rest = 0;
  Vec3<R> grad_F = Vec3<R>::Zero();
  Mat3<R> hess_F = Mat3<R>::Zero();
  for (int i = 0; i < 3; ++i) {
    const FrameEdge<R>& e = f.edges[i];
    F += e.h * even[i].K2;
    rest += even[i].in_plane_rest;
    if (order < 1) continue;
    const Vec3<R> grad_K2 = even[i].gradient_K2(e);
    grad_F += e.h * grad_K2 - even[i].K2 * e.nu;
    if (order >= 2) hess_F += e.h * even[i].hessian_K2(e) - symmetric_outer<R>(e.nu, grad_K2);
  }
  // int 1/r^4 = F/(2 d^2); where the projection lies outside F vanishes with d^2, and the in-plane parts give it without that quotient.
  const bool within = f.edges[0].h >= 0 && f.edges[1].h >= 0 && f.edges[2].h >= 0;
  const R over_d = within ? R(F / f.d) : R(-f.d * rest);
  const Vec3<R> grad_over_d = (grad_F - over_d * f.n) / f.d;
  const Mat3<R> hess_over_d = (hess_F - symmetric_outer<R>(f.n, grad_over_d)) / f.d;
  for (int k = 0; k < 3; ++k) {
    const Vec3<R> g = f.hat_gradient(k);
    const R gamma = f.hat(k);
    R G = 0;
    Vec3<R> grad_G = Vec3<R>::Zero();
    Mat3<R> hess_G = Mat3<R>::Zero();
    for (int i = 0; i < 3; ++i) {
      const R weight = f.edges[i].nu.dot(g);
      G += weight * even[i].K2;
      if (order >= 1) grad_G += weight * even[i].gradient_K2(f.edges[i]);
      if (order >= 2) hess_G += weight * even[i].hessian_K2(f.edges[i]);
    }
    jet.value[k] = (f.d * G - gamma * over_d) / 2;
    if (order >= 1) jet.gradient[k] = (G * f.n + f.d * grad_G - over_d * g - gamma * grad_over_d) / 2;
    if (order >= 2)
      jet.hessian[k] = (symmetric_outer<R>(f.n, grad_G) + f.d * hess_G - symmetric_outer<R>(g, grad_over_d) -
                        gamma * hess_over_d) / 2;
  }
  return finish(jet, -1, f.unit);
}

}  // namespace cageproof::closed_form
