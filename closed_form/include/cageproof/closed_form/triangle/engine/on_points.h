// SPDX-License-Identifier: MIT
// A closed form whose moments are sums over Gauss points, far from the triangle.
#pragma once

#include "cageproof/closed_form/triangle/engine/evaluate.h"
#include "cageproof/closed_form/triangle/engine/far_form.h"
#include "cageproof/closed_form/triangle/engine/panel_form.h"

namespace cageproof::closed_form::triangle {

/// The moments that a formula takes far from the triangle, for derivatives up to order O.
template <class F, class R, int O>
using FarFormOf = FarForm<R, O + F::extra, F::extra == 0 ? O : O + F::extra - 1>;
template <class F, class R, int O>
using PanelFormOf = PanelForm<R, O + F::extra, F::extra == 0 ? O : O + F::extra - 1>;

/// From n x n Gauss-Legendre points, up to degree O.
template <class F, int O, class R>
Components<F, R, O> far_components(const Frame<R>& frame, int n, std::span<const R> parameters) {
  return composed<F, O, R>(FarFormOf<F, R, O>(frame, n), parameters);
}

/// The points a side that the far form needs for `tolerance` at this ellipse_of a frame; nothing where the form near
/// the triangle is the better choice.
template <class F, int O>
std::optional<int> far_points_for(double ellipse, double tolerance, int limit = F::far_limit) {
  return far_points(ellipse, F::far_power, O + F::extra, tolerance, limit);
}

}  // namespace cageproof::closed_form::triangle
