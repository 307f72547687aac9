// SPDX-License-Identifier: MIT
// psi_t and phi_t^k in Urago's form, which [T24] takes from the annex of [Ben-Chen, Weber, Gotsman 2009] without printing it.
// The derivatives follow by the product rule.
#pragma once

#include "cageproof/closed_form/published/solid_angle.h"

namespace cageproof::closed_form::published {

/// C_e = log((l0 + l1 + ||e||)/(l0 + l1 - ||e||))/(4 pi ||e||) ([T24] Appendix C).
template <Scalar R>
R edge_constant(const Edge<R>& e, Misprint misprint = Misprint::None) {
  using std::log;
  const R sum = misprint == Misprint::AppendixC ? R(e.l[0] + e.l[0]) : R(e.l[0] + e.l[1]);  // printed: "l_e0 + l_e0"
  return log((sum + e.length) / (sum - e.length)) / (4 * pi<R>() * e.length);
}
template <Scalar R>
Vec3<R> edge_constant_gradient(const Edge<R>& e) {
  return -(e.unit(0) + e.unit(1)) / (2 * pi<R>() * e.q());
}
template <Scalar R>
Mat3<R> edge_constant_hessian(const Edge<R>& e) {
  const Vec3<R> sum = e.unit(0) + e.unit(1);
  return ((e.l[0] + e.l[1]) / e.q() * tensor<R>(sum, sum) - (e.U(0) + e.U(1))) / (2 * pi<R>() * e.q());
}

/// P = -omega/(4 pi) n + sum_k n x C_k d_k = -grad psi, d_k = t^{k+1} - t^{k+2}.
/// \param derivative whether edges that carry the point count: their logarithm drops out of the values, not of derivatives
template <Scalar R>
Vec3<R> urago_vector(const Setting<R>& s, bool derivative) {
  Vec3<R> p = -omega(s, Misprint::None) / (4 * pi<R>()) * s.n;
  for (const Edge<R>& e : s.edges)
    if (derivative || !e.on_edge) p -= s.n.cross(edge_constant(e) * e.e);
  return p;
}

/// Jacobian of P: minus the Hessian of psi.
template <Scalar R>
Mat3<R> urago_jacobian(const Setting<R>& s) {
  Mat3<R> jacobian = -s.n * omega_gradient(s).transpose() / (4 * pi<R>());
  for (const Edge<R>& e : s.edges) jacobian -= s.n.cross(e.e) * edge_constant_gradient(e).transpose();
  return jacobian;
}

/// J_k = (t^{k+2} - eta) x (t^{k+1} - eta)
template <Scalar R>
Vec3<R> urago_normal(const Setting<R>& s, int k) {
  return Vec3<R>(s.t[(k + 2) % 3] - s.eta).cross(Vec3<R>(s.t[(k + 1) % 3] - s.eta));
}

/// psi_t = -3 omega/(4 pi) Vol/|t| - sum_k C_k J_k.n, Vol the signed volume of (eta, t). \param order 0, 1 or 2
template <Scalar R>
Jet<R, 1> single_layer(const Setting<R>& s, int order, Misprint misprint = Misprint::None) {
  Jet<R, 1> jet;
  if (s.vertex >= 0) {  // Appendix C, strictly on vertices
    jet.value[0] = s.twice_area * edge_constant(s.opposite(s.vertex), misprint);
  } else if (s.inside) {  // Appendix C, strictly inside the triangle
    for (int k = 0; k < 3; ++k) jet.value[0] += s.twice_area * edge_constant(s.opposite(k), misprint) * s.gamma[k];
  } else {
    const Vec3<R> a = s.t[0] - s.eta, b = s.t[1] - s.eta, c = s.t[2] - s.eta;
    if (!s.in_plane) jet.value[0] = -omega(s, Misprint::None) / (4 * pi<R>()) * a.cross(b).dot(c) / s.twice_area;
    for (int k = 0; k < 3; ++k)
      if (!s.opposite(k).on_edge) jet.value[0] -= edge_constant(s.opposite(k)) * urago_normal(s, k).dot(s.n);
  }
  if (order >= 1) jet.gradient[0] = -urago_vector(s, true);
  if (order >= 2) jet.hessian[0] = -urago_jacobian(s);
  return jet;
}

/// The matrix of w x.
template <Scalar R>
Mat3<R> cross_matrix(const Vec3<R>& w) {
  Mat3<R> m;
  m << R(0), -w[2], w[1], w[2], R(0), -w[0], -w[1], w[0], R(0);
  return m;
}

/// n.grad phi_t^k strictly inside the triangle ([T24] Appendix C). The misprint is the curl form's normal component.
template <Scalar R>
R double_layer_normal_derivative(const Setting<R>& s, int k, Misprint misprint) {
  Vec3<R> sum = Vec3<R>::Zero();
  for (const Edge<R>& e : s.edges) sum += e.e * edge_constant(e);
  const R printed = s.n.cross(sum).cross(s.opposite(k).e).dot(s.n) / s.twice_area;
  return misprint == Misprint::AppendixC ? printed : R(printed + s.gamma[k] * s.n.dot(omega_gradient(s)) / (4 * pi<R>()));
}

/// phi_t^k = P.J_k/(2|t|). \param order 0, 1 or 2
template <Scalar R>
Jet<R, 3> double_layer(const Setting<R>& s, int order, Misprint misprint = Misprint::None) {
  Jet<R, 3> jet;
  const R pi4 = 4 * pi<R>();
  const Vec3<R> p = urago_vector(s, false);
  const Vec3<R> p_derivative = order >= 1 ? urago_vector(s, true) : p;
  Mat3<R> dp = Mat3<R>::Zero();
  if (order >= 1) dp = urago_jacobian(s);
  for (int k = 0; k < 3; ++k) {
    const Vec3<R> w = -s.opposite(k).e, j = urago_normal(s, k);
    if (s.vertex >= 0) {  // Appendix C: the solid angle seen from inside, times the corner's delta; printed without 4 pi
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

/// The trap: phi_t^k with P x d_k/(2|t|) for its gradient. That is not the gradient of one triangle's phi_t^k; only the sums
/// over the triangles around each vertex of a closed cage are the gradients of phi_k. \param order 0, 1 or 2
template <Scalar R>
Jet<R, 3> double_layer_curl_form(const Setting<R>& s, int order) {
  Jet<R, 3> jet = double_layer(s, 0);
  for (int k = 0; order >= 1 && k < 3; ++k) {
    const Vec3<R> w = -s.opposite(k).e;
    jet.gradient[k] = urago_vector(s, true).cross(w) / s.twice_area;
    if (order >= 2) jet.hessian[k] = -cross_matrix(w) * urago_jacobian(s) / s.twice_area;
  }
  return jet;
}

}  // namespace cageproof::closed_form::published
