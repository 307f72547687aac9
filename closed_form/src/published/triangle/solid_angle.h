// SPDX-License-Identifier: MIT
// triangle.solid_angle as [T24] Appendix A and Section 3.1 print it.
#pragma once

#include "published/triangle/engine/omega.h"

namespace cageproof::closed_form::published {

/// omega_t = int x.n/r^3 ([T24] Appendix A; derivatives after Eq 12 and 14): one number, in radians. In the plane the
/// value is the limit from inside; on the edges derivatives are not finite. It cancels far away. \param order 0, 1 or 2
template <Scalar R>
Jet<R, 1> solid_angle(const Frame<R>& s, int order, Misprint misprint) {
  Jet<R, 1> jet;
  jet.value[0] = omega(s, misprint);
  if (order >= 1) jet.gradient[0] = omega_gradient(s);
  if (order >= 2) jet.hessian[0] = omega_hessian(s);
  return jet;
}

}  // namespace cageproof::closed_form::published
