// SPDX-License-Identifier: MIT
// triangle.biharmonic_double_layer: [T24] Eq 15-18 and Appendix C.
#pragma once

#include "published/triangle/engine/third_derivative.h"
#include "published/triangle/biharmonic_single_layer.h"
#include "published/triangle/single_layer.h"

namespace cageproof::closed_form::published {

/// n.grad phibar_t^k strictly inside the triangle, a length ([T24] Appendix C). Printed with D_e^2 log for 3 D_e^2 log.
template <Scalar R>
R biharmonic_double_layer_normal_derivative(const Frame<R>& s, int k, const R& psi, Misprint misprint) {
  const Vec3<R>& g = s.g[k];
  R sum = s.gamma[k] * psi / 2;
  for (const Edge<R>& e : s.edges) {
    const R log_terms = (misprint == Misprint::AppendixC ? 1 : 3) * e.D2 * e.log_ratio();
    sum += lambda2<R>() * e.a / 6 * e.D2 * Vec3<R>(e.m(1) - e.m(0)).dot(g);
    sum += lambda2<R>() * e.r.dot(g) / 6 * (log_terms - e.l[1] * e.zeta[1] + e.l[0] * e.zeta[0]);
    sum += lambda2<R>() * e.a / 6 *
           Vec3<R>(e.unit(0) * e.zeta[0] - e.unit(1) * e.zeta[1] + (e.l[0] - e.l[1]) * e.u).dot(g);
  }
  return sum;
}

/// phibar_t^k = int -Gamma_k x.n/(8 pi r) ([T24] Eq 15-18; strictly inside the triangle Appendix C): one number a
/// corner, an area. Next to edges' lines the printed quotients are 0/0: not finite in double. \param order 0, 1 or 2
template <Scalar R>
Jet<R, 3> biharmonic_double_layer(const Frame<R>& s, int order, Misprint misprint = Misprint::None) {
  Jet<R, 3> jet;
  // Appendix C's own misprints: psi and psibar enter here as Section 3 has them.
  const Misprint inherited = misprint == Misprint::AppendixC ? Misprint::None : misprint;
  const Jet<R, 1> bar = biharmonic_single_layer(s, s.in_plane ? order : order + 1, inherited);
  const Jet<R, 1> green = single_layer(s, s.in_plane && order > 0 ? order - 1 : order, inherited);
  const R& psi = green.value[0];
  const Vec3<R>&grad = bar.gradient[0], &grad_psi = green.gradient[0];
  const Mat3<R>& hess = bar.hessian[0];
  for (int k = 0; k < 3; ++k) {
    const Vec3<R>& g = s.g[k];
    const R half = s.gamma[k] / 2;
    if (!s.in_plane) jet.value[k] = -s.d * grad.dot(g) + half * s.d * psi;
    if (order >= 1) {
      jet.gradient[k] = (half * psi - grad.dot(g)) * s.n;
      if (s.inside) jet.gradient[k] = biharmonic_double_layer_normal_derivative(s, k, psi, misprint) * s.n;
      if (!s.in_plane) jet.gradient[k] += -s.d * hess * g + s.d * psi / 2 * g + half * s.d * grad_psi;
    }
    if (order >= 2) {
      const Vec3<R> hg = hess * g;
      jet.hessian[k] = -tensor<R>(s.n, hg) + psi / 2 * tensor<R>(s.n, g) + half * tensor<R>(grad_psi, s.n);
      if (!s.in_plane)
        jet.hessian[k] += s.d * lambda2<R>() * third_derivative(s, g, inherited) + s.d / 2 * tensor<R>(grad_psi, g) +
                          half * s.d * green.hessian[0];
    }
  }
  return jet;
}

}  // namespace cageproof::closed_form::published
