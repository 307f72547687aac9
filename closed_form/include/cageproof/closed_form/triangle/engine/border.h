// SPDX-License-Identifier: MIT
// What a closed form does on the triangle itself, where derivatives, or even the value, may have no limit.
#pragma once

#include "cageproof/closed_form/triangle/engine/point_moments.h"

namespace cageproof::closed_form::triangle {

/// The first derivative order without a limit at this point; 3 where all exist.
template <class F, class R>
int first_divergent(const Frame<R>& f) {
  if (!f.on_triangle()) return 3;
  const bool border = on_edge(f.edges[0]) || on_edge(f.edges[1]) || on_edge(f.edges[2]);
  return F::diverges_on_triangle || border ? F::border_order : 3;
}

/// On the triangle, of formulas that diverge there: infinite where the hat function is positive, NaN where it vanishes,
/// since the limit depends on the direction there; no derivative.
template <class F, int O, Scalar R>
Jet<R, F::components> diverging_weights(const Frame<R>& f) {
  static_assert(F::components == 3);
  Jet<R, F::components> jet = finish<F, O, R>({}, f.unit, 1);
  for (int k = 0; k < 3; ++k)
    jet.value[k] = f.hat(k) > 0 ? std::numeric_limits<R>::infinity() : std::numeric_limits<R>::quiet_NaN();
  return jet;
}

/// On the border, at the first order without a limit: where that diverges like minus the logarithm of the distance, its
/// entries become infinite with the sign of the logarithm's factor; entries without one keep the limit from inside
/// where there is one, else NaN.
template <class F, int O, Scalar R>
void set_infinities(PointMoments<R, O>& at, std::span<const R> parameters, int limit, Jet<R, F::components>& jet) {
  if constexpr (F::on_border != OnBorder::NoLimit && F::border_order <= O) {
    if (limit > O) return;
    const Frame<R>& f = at.frame();
    const auto finite = finish<F, O, R>(composed<F, O, R>(at.moments().template near<F>(), parameters), f.unit, 3);
    const auto moved = finish<F, O, R>(near_components<F, O>(f, parameters, R(1)), f.unit, 3);
    using std::abs, std::max;
    R size = 0;
    for (int c = 0; c < F::components; ++c) {
      if (limit == 0) size = max(size, R(abs(moved.value[c])));
      if (limit == 1) size = max(size, R(moved.gradient[c].cwiseAbs().maxCoeff()));
      if (limit == 2) size = max(size, R(moved.hessian[c].cwiseAbs().maxCoeff()));
    }
    // What differs by rounding alone has no logarithm.
    const R noise = 64 * unit_roundoff<R>() * size;
    const auto set = [&noise](const R& without, const R& with, R& x) {
      if (abs(with - without) > noise)
        x = with > without ? std::numeric_limits<R>::infinity() : -std::numeric_limits<R>::infinity();
      else if (F::on_border == OnBorder::Logarithm) x = without;
    };
    for (int c = 0; c < F::components; ++c) {
      if (limit == 0) set(finite.value[c], moved.value[c], jet.value[c]);
      for (int i = 0; i < 3; ++i) {
        if (limit == 1) set(finite.gradient[c][i], moved.gradient[c][i], jet.gradient[c][i]);
        for (int j = 0; limit == 2 && j < 3; ++j)
          set(finite.hessian[c](i, j), moved.hessian[c](i, j), jet.hessian[c](i, j));
      }
    }
  }
}

}  // namespace cageproof::closed_form::triangle
