// SPDX-License-Identifier: MIT
// The closed form of a triangle formula as one would write it: the near form in the scalar's own arithmetic, with its
// stable branches, and nothing wider. The headers included need only the standard library and Eigen's vectors.
#pragma once

#include "cageproof/closed_form/triangle/engine/limits.h"
#include "cageproof/closed_form/triangle/engine/plain_frame.h"

namespace cageproof::closed_form::triangle {

/// A single formula at a single point. Units and limits: at the formula. Digits are lost where its terms cancel: far
/// from the triangle, on slivers, and next to the lines of edges.
/// \tparam R float or double, the type of every operation
/// \param t corners, counter-clockwise seen from outside \param eta the point \param parameters F::parameter_count of
/// them \param finite_part Batch::finite_part (core/catalogue/batch.h) \return value and derivatives up to order O; NaN
/// where an order has no limit, as the scalar's own numbers see the point
template <class F, int O, class R>
Jet<R, F::components> plain(const Triangle<R>& t, const Vec3<R>& eta, std::span<const R> parameters = {},
                            bool finite_part = false) {
  const Frame<R> f = plain_frame(t, eta);
  int limit = first_divergent<F>(f);
  if (limit == 0 && finite_part) limit = 1;
  if constexpr (F::diverges_on_triangle)
    if (limit < 3) return diverging_weights<F, O, R>(f);
  return finish<F, O, R>(near_components<F, O, R>(f, parameters), f.unit, limit);
}

}  // namespace cageproof::closed_form::triangle
