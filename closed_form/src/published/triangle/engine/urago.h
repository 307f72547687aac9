// SPDX-License-Identifier: MIT
// Urago's vector P, from which psi_t and phi_t^k follow; [T24] takes it from the annex of [Ben-Chen, Weber, Gotsman
// 2009] without printing it. Derivatives are by the product rule.
#pragma once

#include "published/triangle/engine/omega.h"

namespace cageproof::closed_form::published {

/// C_e = log((l0 + l1 + ||e||)/(l0 + l1 - ||e||))/(4 pi ||e||) ([T24] Appendix C): 1/length. Infinite on the edge.
template <Scalar R>
R edge_constant(const Edge<R>& e, Misprint misprint = Misprint::None) {
  using std::log;
  const R sum = misprint == Misprint::AppendixC ? R(e.l[0] + e.l[0]) : R(e.l[0] + e.l[1]);  // printed: "l_e0 + l_e0"
  return log((sum + e.length) / (sum - e.length)) / (4 * pi<R>() * e.length);
}
/// grad C_e; not finite on the edge.
template <Scalar R>
Vec3<R> edge_constant_gradient(const Edge<R>& e) {
  return -(e.unit(0) + e.unit(1)) / (2 * pi<R>() * e.q());
}
/// Hessian of C_e; not finite on the edge.
template <Scalar R>
Mat3<R> edge_constant_hessian(const Edge<R>& e) {
  const Vec3<R> sum = e.unit(0) + e.unit(1);
  return ((e.l[0] + e.l[1]) / e.q() * tensor<R>(sum, sum) - (e.U(0) + e.U(1))) / (2 * pi<R>() * e.q());
}

/// P = -omega/(4 pi) n + sum_k n x C_k d_k = -grad psi, d_k = t^{k+1} - t^{k+2}: unitless.
/// \param derivative whether edges that carry the point count: their logarithm drops out of the values, not of
/// derivatives
template <Scalar R>
Vec3<R> urago_vector(const Frame<R>& s, bool derivative) {
  Vec3<R> p = -omega(s, Misprint::None) / (4 * pi<R>()) * s.n;
  for (const Edge<R>& e : s.edges)
    if (derivative || !e.on_edge) p -= s.n.cross(edge_constant(e) * e.e);
  return p;
}

/// The Jacobian of P, 1/length, which is minus the Hessian of psi. Not finite on the edges.
template <Scalar R>
Mat3<R> urago_jacobian(const Frame<R>& s) {
  Mat3<R> jacobian = -s.n * omega_gradient(s).transpose() / (4 * pi<R>());
  for (const Edge<R>& e : s.edges) jacobian -= s.n.cross(e.e) * edge_constant_gradient(e).transpose();
  return jacobian;
}

/// J_k = (t^{k+2} - eta) x (t^{k+1} - eta), an area.
template <Scalar R>
Vec3<R> urago_normal(const Frame<R>& s, int k) {
  return Vec3<R>(s.t[(k + 2) % 3] - s.eta).cross(Vec3<R>(s.t[(k + 1) % 3] - s.eta));
}

}  // namespace cageproof::closed_form::published
