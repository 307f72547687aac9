// SPDX-License-Identifier: MIT
// On the triangle: which orders, the value included, have no limit.
#pragma once

#include "cageproof/closed_form/triangle/engine/evaluate.h"

namespace cageproof::closed_form::triangle {

/// The first derivative order without a limit at this point; 3 where all exist.
template <class F, class R>
int first_divergent(const Frame<R>& f) {
  if (!f.on_triangle()) return 3;
  const bool border = on_edge(f.edges[0]) || on_edge(f.edges[1]) || on_edge(f.edges[2]);
  return F::diverges_on_triangle || border ? F::border_order : 3;
}

/// The result on the triangle of a formula that diverges all over it: values are infinite where the corner's hat
/// function is positive, and NaN where it vanishes, since the limit depends on the direction there; derivatives are
/// NaN.
template <class F, int O, Scalar S, class R>
Jet<S, F::components> diverging_weights(const Frame<R>& f) {
  static_assert(F::components == 3);
  Jet<S, F::components> jet = finish<F, O, S>({}, S(1), 1);
  for (int k = 0; k < 3; ++k)
    jet.value[k] = f.hat(k) > R(0) ? std::numeric_limits<S>::infinity() : std::numeric_limits<S>::quiet_NaN();
  return jet;
}

}  // namespace cageproof::closed_form::triangle
