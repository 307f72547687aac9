// SPDX-License-Identifier: MIT
// triangle.biharmonic_single_layer: [T24] Eq 9-14 and Appendix C.
#pragma once

#include "published/triangle/engine/distance_integral.h"

namespace cageproof::closed_form::published {

/// [T24] Appendix C, psibar strictly inside a triangle (all edges) and on a vertex (the opposite edge). Printed without
/// -lambda_2, and with a wrong power of a.
template <Scalar R>
R special_biharmonic_single_layer(const Frame<R>& s, Misprint misprint) {
  R sum(0);
  for (int k = 0; k < 3; ++k) {
    if (s.vertex >= 0 && s.vertex != k) continue;
    const Edge<R>& e = s.opposite(k);
    const R ends = e.l[0] * e.zeta[0] - e.l[1] * e.zeta[1];
    if (misprint == Misprint::AppendixC) {
      const R a = s.vertex >= 0 ? e.a : R(e.a * e.a * e.a);
      sum += a / 6 * (e.log_ratio() + ends);
    } else {
      sum -= lambda2<R>() * e.a / 6 * (e.a * e.a * e.log_ratio() + ends);
    }
  }
  return sum;
}

/// psibar_t = -lambda_2 int r ([T24] Eq 9, 11, 13; strictly inside the triangle and on vertices Appendix C): one
/// number, a volume. Next to edges' lines the printed quotients are 0/0: not finite in double. \param order 0, 1 or 2
template <Scalar R>
Jet<R, 1> biharmonic_single_layer(const Frame<R>& s, int order, Misprint misprint = Misprint::None) {
  Jet<R, 1> jet;
  const bool special = s.inside || s.vertex >= 0;
  jet.value[0] =
      special ? special_biharmonic_single_layer(s, misprint) : R(-lambda2<R>() * distance_integral(s, misprint));
  if (order >= 1) jet.gradient[0] = -lambda2<R>() * distance_integral_gradient(s, misprint);
  if (order >= 2) jet.hessian[0] = -lambda2<R>() * distance_integral_hessian(s, misprint);
  return jet;
}

}  // namespace cageproof::closed_form::published
