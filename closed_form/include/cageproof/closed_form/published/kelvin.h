// SPDX-License-Identifier: MIT
// Somigliana coordinates: [T24] Eq 47-49. The paper prints no derivatives.
#pragma once

#include "cageproof/closed_form/published/affine_single_layer.h"

namespace cageproof::closed_form::published {

/// a and b of [T24] Eq 48: b = a/(4 (1 - nu)), printed "a/4(1 - nu)".
template <Scalar R>
struct Elasticity {
  R mu, a, b;
  Elasticity(const R& shear_modulus, const R& nu, Misprint misprint) : mu(shear_modulus), a(1 / (4 * pi<R>() * mu)) {
    b = misprint == Misprint::Equation48 ? R(a / 4 * (1 - nu)) : R(a / (4 * (1 - nu)));
  }
};

/// K_t, row by row.
template <Scalar R>
Jet<R, 9> kelvin_displacement(const Setting<R>& s, const R& mu, const R& nu, Misprint misprint) {
  const Elasticity<R> m(mu, nu, misprint);
  const Mat3<R> K = m.b / lambda2<R>() * biharmonic_single_layer(s, 2, misprint).hessian[0] -
                    m.a / lambda1<R>() * single_layer(s, 0).value[0] * Mat3<R>::Identity();
  Jet<R, 9> jet;
  for (int i = 0; i < 9; ++i) jet.value[i] = K(i / 3, i % 3);
  return jet;
}

/// T_t^k, corner by corner, row by row. Printed without mu.
template <Scalar R>
Jet<R, 27> kelvin_traction(const Setting<R>& s, const R& mu, const R& nu, Misprint misprint) {
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
