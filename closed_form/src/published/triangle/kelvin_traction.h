// SPDX-License-Identifier: MIT
// triangle.kelvin_traction: [T24] Eq 47-49. The paper prints no derivatives.
#pragma once

#include "published/triangle/engine/elasticity.h"
#include "published/triangle/affine_single_layer.h"
#include "published/triangle/double_layer.h"

namespace cageproof::closed_form::published {

/// T_t^k ([T24] Eq 49, printed without mu): 3 x 3 numbers per corner, row by row, unitless. Values only. Not finite
/// where psi_t^k's derivatives are not. \param mu shear modulus, positive \param nu Poisson ratio, below 1
template <Scalar R>
Jet<R, 27> kelvin_traction(const Frame<R>& s, const R& mu, const R& nu, Misprint misprint) {
  const Elasticity<R> m(mu, nu, misprint);
  const R factor = (misprint == Misprint::Equation49 ? R(1) : mu) / lambda1<R>();
  const Jet<R, 3> phi = double_layer(s, 0), affine = affine_single_layer(s, s.in_plane ? 1 : 2, misprint);
  Jet<R, 27> jet;
  for (int k = 0; k < 3; ++k) {
    const Mat3<R> skew = s.n * affine.gradient[k].transpose() - affine.gradient[k] * s.n.transpose();
    Mat3<R> T = -m.a * phi.value[k] * Mat3<R>::Identity() - (m.a - 2 * m.b) * skew;
    if (!s.in_plane) T += 2 * m.b * s.d * affine.hessian[k];
    for (int i = 0; i < 9; ++i) jet.value[9 * k + i] = factor * T(i / 3, i % 3);
  }
  return jet;
}

}  // namespace cageproof::closed_form::published
