// SPDX-License-Identifier: MIT
#pragma once

#include "cageproof/closed_form/triangle/finish.h"
#include "cageproof/closed_form/triangle/potentials.h"

namespace cageproof::closed_form {

/// psibar_t = int_t r/(8 pi), the biharmonic single layer ([T24] Eq 9-14; edge form): length^3; gradient length^2; Hessian length.
/// Value, gradient and Hessian are finite and continuous everywhere.
template <Scalar R>
Jet<R, 1> biharmonic_single_layer(const Triangle<R>& t, const Vec3<R>& eta, int order) {
  const Potentials<R> q(t, eta);
  const R c = 1 / (8 * pi<R>());
  Jet<R, 1> jet;
  jet.value[0] = c * q.I();
  if (order >= 1) jet.gradient[0] = c * q.grad_I();
  if (order >= 2) jet.hessian[0] = c * q.hess_I();
  return finish(jet, 3, q.frame().unit);
}

}  // namespace cageproof::closed_form
