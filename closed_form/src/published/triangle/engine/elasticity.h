// SPDX-License-Identifier: MIT
// The constants of elasticity: [T24] Eq 48.
#pragma once

#include "cageproof/closed_form/published/misprint.h"
#include "published/triangle/engine/frame.h"

namespace cageproof::closed_form::published {

/// The shear modulus mu, and a = 1/(4 pi mu) and b = a/(4 (1 - nu)) of [T24] Eq 48, printed "a/4(1 - nu)". Not finite
/// at nu = 1, and no limit is taken for an infinite Poisson ratio nu.
template <Scalar R>
struct Elasticity {
  R mu, a, b;
  Elasticity(const R& shear_modulus, const R& nu, Misprint misprint) : mu(shear_modulus), a(1 / (4 * pi<R>() * mu)) {
    b = misprint == Misprint::Equation48 ? R(a / 4 * (1 - nu)) : R(a / (4 * (1 - nu)));
  }
};

}  // namespace cageproof::closed_form::published
