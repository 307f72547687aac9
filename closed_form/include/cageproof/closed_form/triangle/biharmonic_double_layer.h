// SPDX-License-Identifier: MIT
#pragma once

#include "cageproof/closed_form/triangle/finish.h"
#include "cageproof/closed_form/triangle/potentials.h"

namespace cageproof::closed_form {

/// phibar_t^k = int_t -Gamma_k x.n/(8 pi r), the biharmonic double layer of the three hat functions ([T24] Eq 15-18; edge form): length^2;
/// gradient length; Hessian 1. Value and gradient are finite and continuous everywhere; on the triangle's border the Hessian does not exist
/// (NaN), within it is the limit from inside.
template <Scalar R>
Jet<R, 3> biharmonic_double_layer(const Triangle<R>& t, const Vec3<R>& eta, int order) {
  const Potentials<R> q(t, eta);
  const R c = 1 / (8 * pi<R>());
  const R& d = q.frame().d;
  const Vec3<R>& n = q.frame().n;
  const bool border = q.on_border();
  const Vec3<R> gradient = order >= 1 ? q.grad_J() : Vec3<R>::Zero();
  const Mat3<R> hessian = order >= 2 && !border ? q.hess_J() : Mat3<R>::Zero();
  Jet<R, 3> jet;
  for (int k = 0; k < 3; ++k) {
    const auto hat = q.hat(k);
    const R A = q.A(hat);
    jet.value[k] = c * d * A;
    if (order < 1) continue;
    const Vec3<R> grad_A = q.grad_A(hat, gradient);
    jet.gradient[k] = c * (A * n + d * grad_A);
    if (order >= 2 && !border)
      jet.hessian[k] = c * (symmetric_outer<R>(n, grad_A) + d * q.hess_A(hat, gradient, hessian));
  }
  return finish(jet, 2, q.frame().unit, border ? 2 : 3);
}

}  // namespace cageproof::closed_form
