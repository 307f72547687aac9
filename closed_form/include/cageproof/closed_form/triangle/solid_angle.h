// SPDX-License-Identifier: MIT
#pragma once

#include "cageproof/closed_form/triangle/finish.h"
#include "cageproof/closed_form/triangle/potentials.h"

namespace cageproof::closed_form {

/// omega_t = int_t x.n/r^3, the solid angle ([T24] Appendix A with the sign of its erratum; edge form): radians, in (-2 pi, 2 pi],
/// positive where the normal points away from the point (inside a cage). On the triangle: the limit from inside, 2 pi within, pi on an
/// edge, the triangle's angle at a corner; derivatives there as limits from inside, NaN on the border, where they do not exist.
template <Scalar R>
Jet<R, 1> solid_angle(const Triangle<R>& t, const Vec3<R>& eta, int order) {
  const Potentials<R> q(t, eta);
  Jet<R, 1> jet;
  jet.value[0] = q.omega();
  if (order >= 1) jet.gradient[0] = q.grad_omega();
  if (order >= 2) jet.hessian[0] = q.hess_omega();
  return finish(jet, 0, q.frame().unit, q.on_border() ? 1 : 3);
}

}  // namespace cageproof::closed_form
