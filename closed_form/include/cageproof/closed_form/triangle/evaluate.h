// SPDX-License-Identifier: MIT
// One formula at one point: which moments to take it from, and how many digits that needs.
#pragma once

#include "cageproof/closed_form/triangle/edge_form.h"
#include "cageproof/closed_form/triangle/even_form.h"
#include "cageproof/closed_form/triangle/far_form.h"
#include "cageproof/closed_form/triangle/formulas.h"

namespace cageproof::closed_form {

/// A formula's components as Taylor polynomials.
template <class F, class R, int O>
using Components = std::array<Taylor<R, O>, F::components>;

/// From the edge form, up to degree O.
template <class F, int O, class R>
Components<F, R, O> near_components(const Frame<R>& frame, std::span<const R> parameters, const R& border_log = R(0)) {
  Components<F, R, O> out;
  if constexpr (std::same_as<F, MeanValue>) {
    F::compose(EvenForm<R, O>(frame), parameters, out);
  } else {
    F::compose(EdgeForm<R, O + F::extra, F::extra == 0 ? O : O + F::extra - 1>(frame, border_log), parameters, out);
  }
  return out;
}

/// From n x n Gauss-Legendre points, up to degree O.
template <class F, int O, class R>
Components<F, R, O> far_components(const Frame<R>& frame, int n, std::span<const R> parameters) {
  Components<F, R, O> out;
  F::compose(FarForm<R, O + F::extra, F::extra == 0 ? O : O + F::extra - 1>(frame, n), parameters, out);
  return out;
}

/// The points a side that the far form needs for `tolerance` here; nothing where the edge form is the better choice.
template <class F, int O, Scalar R>
std::optional<int> far_points_for(const Frame<R>& frame, double tolerance) {
  if constexpr (std::same_as<F, MeanValue>) return far_points(ellipse_of_distance(frame), F::far_power, O + F::extra, tolerance, kCancellingLimit);
  return far_points(ellipse_of(frame), F::far_power, O + F::extra, tolerance, kFarLimit);
}

/// The numbers of derivative order o in a polynomial: f, f_i, f_ij for i <= j, with the factor by which a coefficient is multiplied.
template <int O>
constexpr int derivative_factor(int m) {
  int factor = 1;
  for (const int e : Monomials<O>::exponents[m]) factor *= e == 2 ? 2 : 1;
  return factor;
}

/// Brings components from frame units back to the caller's, as a jet: order k of a formula of degree m scales with unit^(m - k).
/// Orders from `first_divergent` on have no limit here (the point is on the border) and become NaN.
template <class F, int O, Scalar R>
Jet<R, F::components> finish(const Components<F, R, O>& from, const R& unit, int first_divergent) {
  const auto power = [&unit](int exponent) {
    if constexpr (is_multiprecision<R>) return R(1);
    else return R(std::ldexp(R(1), exponent * std::ilogb(unit)));
  };
  const std::array<R, 3> scale{power(F::degree), power(F::degree - 1), power(F::degree - 2)};
  Jet<R, F::components> jet;
  for (int c = 0; c < F::components; ++c)
    for (int m = 0; m < Monomials<O>::count; ++m) {
      const auto& e = Monomials<O>::exponents[m];
      const int order = e[0] + e[1] + e[2];
      const R x = order >= first_divergent ? std::numeric_limits<R>::quiet_NaN()
                                           : R(from[c].c[m] * R(derivative_factor<O>(m)) * scale[order]);
      if (order == 0) jet.value[c] = x;
      if (order == 1) jet.gradient[c][e[1] + 2 * e[2]] = x;
      if (order != 2) continue;
      const int i = e[0] > 0 ? 0 : e[1] > 0 ? 1 : 2, j = e[2] > 0 ? 2 : e[1] > 0 ? 1 : 0;
      jet.hessian[c](i, j) = jet.hessian[c](j, i) = x;
    }
  return jet;
}

/// The first derivative order without a limit at this point; 3 where all exist.
template <class F, class R>
int first_divergent(const Frame<R>& f) {
  if (!f.on_triangle()) return 3;
  const bool border = on_edge(f.edges[0]) || on_edge(f.edges[1]) || on_edge(f.edges[2]);
  return std::same_as<F, MeanValue> || border ? F::border_order : 3;
}

/// The mean value weights on the triangle: infinite where the hat function is positive; no derivative.
template <class F, int O, Scalar R>
Jet<R, F::components> diverging_weights(const Frame<R>& f) {
  Jet<R, F::components> jet = finish<F, O, R>({}, f.unit, 1);
  for (int k = 0; k < 3; ++k)
    if (f.hat(k) > 0) jet.value[k] = std::numeric_limits<R>::infinity();
  return jet;
}

/// On the border, at the first order without a limit: where that diverges like minus the logarithm of the distance, its entries become
/// infinite with the sign of the logarithm's factor; entries without one keep the limit from inside where there is one, else NaN.
template <class F, int O, Scalar R>
void set_infinities(const Frame<R>& f, std::span<const R> parameters, int limit, Jet<R, F::components>& jet) {
  if (limit > O || F::on_border == OnBorder::NoLimit) return;
  const auto finite = finish<F, O, R>(near_components<F, O>(f, parameters), f.unit, 3);
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
    if (abs(with - without) > noise) x = with > without ? std::numeric_limits<R>::infinity() : -std::numeric_limits<R>::infinity();
    else if (F::on_border == OnBorder::Logarithm) x = without;
  };
  for (int c = 0; c < F::components; ++c) {
    if (limit == 0) set(finite.value[c], moved.value[c], jet.value[c]);
    for (int i = 0; i < 3; ++i) {
      if (limit == 1) set(finite.gradient[c][i], moved.gradient[c][i], jet.gradient[c][i]);
      for (int j = 0; limit == 2 && j < 3; ++j) set(finite.hessian[c](i, j), moved.hessian[c](i, j), jet.hessian[c](i, j));
    }
  }
}

}  // namespace cageproof::closed_form
