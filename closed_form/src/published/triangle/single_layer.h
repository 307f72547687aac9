// SPDX-License-Identifier: MIT
// triangle.single_layer in Urago's form, which [T24] refers to.
#pragma once

#include "published/triangle/engine/urago.h"

namespace cageproof::closed_form::published {

/// psi_t = -3 omega/(4 pi) Vol/|t| - sum_k C_k J_k.n, Vol the signed volume of (eta, t) (Urago; on the triangle [T24]
/// Appendix C): one number, a length. On the border derivatives are not finite. \param order 0, 1 or 2
template <Scalar R>
Jet<R, 1> single_layer(const Frame<R>& s, int order, Misprint misprint = Misprint::None) {
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

}  // namespace cageproof::closed_form::published
