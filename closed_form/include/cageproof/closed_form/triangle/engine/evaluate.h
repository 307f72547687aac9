// SPDX-License-Identifier: MIT
// One closed form from given moments: its components, and these as a jet in the caller's units.
#pragma once

#include "cageproof/closed_form/arithmetic/jet.h"
#include "cageproof/closed_form/arithmetic/working.h"
#include "cageproof/closed_form/triangle/engine/kernel.h"

namespace cageproof::closed_form::triangle {

/// A formula's parameters in the scalar that it computes in.
template <class F, Scalar R, Scalar W = Working<R>>
std::array<W, F::parameter_count> widened(std::span<const R> parameters) {
  std::array<W, F::parameter_count> wide;
  for (int i = 0; i < F::parameter_count; ++i) wide[i] = parameters[i];
  return wide;
}

/// A formula's components as Taylor polynomials.
template <class F, class R, int O>
using Components = std::array<Taylor<R, O>, F::components>;

/// The moments that a formula takes near the triangle, for derivatives up to order O.
template <class F, class R, int O>
using NearForm = typename F::template Near<F, R, O>;

/// A formula's components from near or far moments, up to degree O.
template <class F, int O, class R, class Form>
Components<F, R, O> composed(const Form& moments, std::span<const R> parameters) {
  Components<F, R, O> out;
  F::compose(moments, parameters, out);
  return out;
}

/// A formula's components from its near form, up to degree O. \param border_log as EdgeForm's
template <class F, int O, class R, class... BorderLog>
Components<F, R, O> near_components(const Frame<R>& frame, std::span<const R> parameters,
                                    const BorderLog&... border_log) {
  return composed<F, O, R>(NearForm<F, R, O>(frame, border_log...), parameters);
}

/// The factor that turns coefficient m into a derivative, for orders up to 2: the product of its exponents' factorials.
template <int O>
constexpr int derivative_factor(int m) {
  int factor = 1;
  for (const int e : Monomials<O>::exponents[m]) factor *= e == 2 ? 2 : 1;
  return factor;
}

/// Brings components from frame units back to the caller's, as a jet: order k of a formula of degree m scales with
/// unit^(m - k). Orders from `first_divergent` on have no limit here (the point is on the border) and become NaN.
template <class F, int O, Scalar R>
Jet<R, F::components> finish(const Components<F, R, O>& from, const R& unit, int first_divergent) {
  std::array<int, 3> exponent{};
  std::array<R, 3> scale{1, 1, 1};
  if constexpr (!is_multiprecision<R>)
    for (int order = 0; order < 3; ++order) {
      exponent[order] = (F::degree - order) * std::ilogb(unit);
      scale[order] = std::ldexp(R(1), exponent[order]);
    }
  Jet<R, F::components> jet;
  for (int c = 0; c < F::components; ++c)
    for (int m = 0; m < Monomials<O>::count; ++m) {
      const auto& e = Monomials<O>::exponents[m];
      const int order = e[0] + e[1] + e[2];
      R x = std::numeric_limits<R>::quiet_NaN();
      if (order < first_divergent) {
        x = from[c].c[m] * R(derivative_factor<O>(m));
        // The scale may leave the range of numbers where the result does not.
        if constexpr (!is_multiprecision<R>) {
          if (std::isnormal(scale[order])) x *= scale[order];
          else x = std::ldexp(x, exponent[order]);
        }
      }
      if (order == 0) jet.value[c] = x;
      if (order == 1) jet.gradient[c][e[1] + 2 * e[2]] = x;
      if (order != 2) continue;
      const int i = e[0] > 0 ? 0 : e[1] > 0 ? 1 : 2, j = e[2] > 0 ? 2 : e[1] > 0 ? 1 : 0;
      jet.hessian[c](i, j) = jet.hessian[c](j, i) = x;
    }
  return jet;
}

}  // namespace cageproof::closed_form::triangle
