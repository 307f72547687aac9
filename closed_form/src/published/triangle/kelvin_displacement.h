// SPDX-License-Identifier: MIT
// triangle.kelvin_displacement: [T24] Eq 47-49. The paper prints no derivatives.
#pragma once

#include "published/triangle/engine/elasticity.h"
#include "published/triangle/biharmonic_single_layer.h"
#include "published/triangle/single_layer.h"

namespace cageproof::closed_form::published {

/// K_t ([T24] Eq 49): 3 x 3 numbers row by row, a length over a modulus. Values only. Not finite where the Hessian of
/// psibar_t is not. \param mu shear modulus, positive \param nu Poisson ratio, below 1
template <Scalar R>
Jet<R, 9> kelvin_displacement(const Frame<R>& s, const R& mu, const R& nu, Misprint misprint) {
  const Elasticity<R> m(mu, nu, misprint);
  const Mat3<R> K = m.b / lambda2<R>() * biharmonic_single_layer(s, 2, misprint).hessian[0] -
                    m.a / lambda1<R>() * single_layer(s, 0).value[0] * Mat3<R>::Identity();
  Jet<R, 9> jet;
  for (int i = 0; i < 9; ++i) jet.value[i] = K(i / 3, i % 3);
  return jet;
}

}  // namespace cageproof::closed_form::published
