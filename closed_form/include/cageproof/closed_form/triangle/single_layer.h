// SPDX-License-Identifier: MIT
#pragma once

#include "cageproof/closed_form/triangle/finish.h"
#include "cageproof/closed_form/triangle/potentials.h"

namespace cageproof::closed_form {

/// psi_t = int_t 1/(4 pi r), the harmonic single layer ([T24] Eq 3; edge form): length; gradient 1; Hessian 1/length.
/// Finite everywhere. On the triangle the derivatives are the limits from inside; on its border they do not exist (NaN).
template <Scalar R>
Jet<R, 1> single_layer(const Triangle<R>& t, const Vec3<R>& eta, int order) {
  const Potentials<R> q(t, eta);
  const R c = 1 / (4 * pi<R>());
  Jet<R, 1> jet;
  jet.value[0] = c * q.J();
  if (order >= 1) jet.gradient[0] = c * q.grad_J();
  if (order >= 2) jet.hessian[0] = c * q.hess_J();
  return finish(jet, 1, q.frame().unit, q.on_border() ? 1 : 3);
}

}  // namespace cageproof::closed_form
