// SPDX-License-Identifier: MIT
// triangle.double_layer in Urago's form, which [T24] refers to.
#pragma once

#include "published/triangle/engine/urago.h"

namespace cageproof::closed_form::published {

/// The matrix of v -> w x v.
template <Scalar R>
Mat3<R> cross_matrix(const Vec3<R>& w) {
  Mat3<R> m;
  m << R(0), -w[2], w[1], w[2], R(0), -w[0], -w[1], w[0], R(0);
  return m;
}

/// n.grad phi_t^k strictly inside the triangle, 1/length ([T24] Appendix C). The misprint is the curl form's normal
/// component.
template <Scalar R>
R double_layer_normal_derivative(const Frame<R>& s, int k, Misprint misprint) {
  Vec3<R> sum = Vec3<R>::Zero();
  for (const Edge<R>& e : s.edges) sum += e.e * edge_constant(e);
  const R printed = s.n.cross(sum).cross(s.opposite(k).e).dot(s.n) / s.twice_area;
  return misprint == Misprint::AppendixC ? printed
                                         : R(printed + s.gamma[k] * s.n.dot(omega_gradient(s)) / (4 * pi<R>()));
}

/// phi_t^k = P.J_k/(2|t|) (Urago; on the triangle [T24] Appendix C, limits from inside): a number per corner, unitless.
/// Derivatives are not finite on the edges. It cancels far away. \param order 0, 1 or 2
template <Scalar R>
Jet<R, 3> double_layer(const Frame<R>& s, int order, Misprint misprint = Misprint::None) {
  Jet<R, 3> jet;
  const R pi4 = 4 * pi<R>();
  const Vec3<R> p = urago_vector(s, false);
  const Vec3<R> p_derivative = order >= 1 ? urago_vector(s, true) : p;
  Mat3<R> dp = Mat3<R>::Zero();
  if (order >= 1) dp = urago_jacobian(s);
  for (int k = 0; k < 3; ++k) {
    const Vec3<R> w = -s.opposite(k).e, j = urago_normal(s, k);
    if (s.vertex >=
        0) {  // Appendix C: the solid angle seen from inside, times the corner's delta; printed without 4 pi
      if (k == s.vertex) jet.value[k] = omega(s, Misprint::None) / (misprint == Misprint::AppendixC ? R(1) : pi4);
    } else {
      jet.value[k] = s.inside ? R(s.gamma[k] / 2) : R(p.dot(j) / s.twice_area);
    }
    if (order >= 1) {
      jet.gradient[k] = (dp.transpose() * j + p_derivative.cross(w)) / s.twice_area;
      if (s.inside)
        jet.gradient[k] += (double_layer_normal_derivative(s, k, misprint) - s.n.dot(jet.gradient[k])) * s.n;
    }
    if (order >= 2) {
      Mat3<R> h = -s.n.dot(j) / pi4 * omega_hessian(s);
      for (const Edge<R>& e : s.edges) h -= s.n.cross(e.e).dot(j) * edge_constant_hessian(e);
      const Mat3<R> turned = dp.transpose() * cross_matrix(w);
      jet.hessian[k] = (h + turned + turned.transpose()) / s.twice_area;
    }
  }
  return jet;
}

/// The trap: phi_t^k with P x d_k/(2|t|) for its gradient. That is not the gradient of one triangle's phi_t^k; only the
/// sums over the triangles around each vertex of a closed cage are the gradients of phi_k. \param order 0, 1 or 2
template <Scalar R>
Jet<R, 3> double_layer_curl_form(const Frame<R>& s, int order) {
  Jet<R, 3> jet = double_layer(s, 0);
  for (int k = 0; order >= 1 && k < 3; ++k) {
    const Vec3<R> w = -s.opposite(k).e;
    jet.gradient[k] = urago_vector(s, true).cross(w) / s.twice_area;
    if (order >= 2) jet.hessian[k] = -cross_matrix(w) * urago_jacobian(s) / s.twice_area;
  }
  return jet;
}

}  // namespace cageproof::closed_form::published
