// SPDX-License-Identifier: MIT
#pragma once

#include "cageproof/closed_form/triangle/finish.h"
#include "cageproof/closed_form/triangle/potentials.h"

namespace cageproof::closed_form {

/// phi_t^k = int_t Gamma_k x.n/(4 pi r^3), the harmonic double layer of the three hat functions ([T24] Eq 3; edge form): unitless.
/// On the triangle: the limit from inside, Gamma_k/2 within; derivatives there as limits from inside, NaN on the border, where they do not
/// exist. The gradient is that of this one triangle's phi, not the "curl form" that is right only summed over a closed cage.
template <Scalar R>
Jet<R, 3> double_layer(const Triangle<R>& t, const Vec3<R>& eta, int order) {
  const Potentials<R> q(t, eta);
  const R c = 1 / (4 * pi<R>());
  const Vec3<R> gradient = order >= 1 ? q.grad_omega() : Vec3<R>::Zero();
  const Mat3<R> hessian = order >= 2 ? q.hess_omega() : Mat3<R>::Zero();
  Jet<R, 3> jet;
  for (int k = 0; k < 3; ++k) {
    const auto hat = q.hat(k);
    jet.value[k] = c * q.B(hat);
    if (order >= 1) jet.gradient[k] = c * q.grad_B(hat, gradient);
    if (order >= 2) jet.hessian[k] = c * q.hess_B(hat, gradient, hessian);
  }
  return finish(jet, 0, q.frame().unit, q.on_border() ? 1 : 3);
}

}  // namespace cageproof::closed_form
