// SPDX-License-Identifier: MIT
// triangle.affine_single_layer: [T24] Eq 43-46.
#pragma once

#include "published/triangle/engine/third_derivative.h"
#include "published/triangle/biharmonic_single_layer.h"
#include "published/triangle/single_layer.h"

namespace cageproof::closed_form::published {

/// psi_t^k = int Gamma_k/(4 pi r) ([T24] Eq 43-46): one number per corner, a length. Not finite where psibar_t's
/// derivatives are not; the Hessian is not finite on the lines of the edges, beyond their ends too, since Eq 18 has no
/// blue terms. \param order 0, 1 or 2
template <Scalar R>
Jet<R, 3> affine_single_layer(const Frame<R>& s, int order, Misprint misprint = Misprint::None) {
  Jet<R, 3> jet;
  const Jet<R, 1> bar = biharmonic_single_layer(s, order < 2 ? order + 1 : 2, misprint);
  const Jet<R, 1> green = single_layer(s, order, misprint);
  for (int k = 0; k < 3; ++k) {
    const Vec3<R>& g = s.g[k];
    jet.value[k] = -2 * bar.gradient[0].dot(g) + s.gamma[k] * green.value[0];
    if (order >= 1) jet.gradient[k] = -2 * bar.hessian[0] * g + s.gamma[k] * green.gradient[0] + green.value[0] * g;
    if (order >= 2)
      jet.hessian[k] = 2 * lambda2<R>() * third_derivative(s, g, misprint) + tensor<R>(green.gradient[0], g) +
                       s.gamma[k] * green.hessian[0];
  }
  return jet;
}

}  // namespace cageproof::closed_form::published
