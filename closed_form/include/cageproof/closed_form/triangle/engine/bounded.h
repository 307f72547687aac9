// SPDX-License-Identifier: MIT
// A closed form's results with a bound of their error, from numbers that carry one along.
#pragma once

#include "cageproof/closed_form/arithmetic/bounded_jet.h"
#include "cageproof/closed_form/triangle/engine/evaluate.h"

namespace cageproof::closed_form::triangle {

/// The components rounded to S with their error bounds; orders from `limit` on are left out of the bounds.
template <class F, int O, Scalar S, class T>
BoundedJet<S, F::components> bounded(const Components<F, Tracked<T>, O>& from, const S& unit, int limit) {
  // Squares of what multiprecision holds may leave double's range.
  using Sum = std::conditional_t<is_multiprecision<T>, T, double>;
  using Bound = ErrorOf<S>;
  const auto squared = [](const Sum& x) { return Sum(x * x); };
  Components<F, S, O> plain;
  std::array<Sum, 3> size{}, error{};
  for (int c = 0; c < F::components; ++c)
    for (int m = 0; m < Monomials<O>::count; ++m) {
      const auto& e = Monomials<O>::exponents[m];
      const int order = e[0] + e[1] + e[2], factor = derivative_factor<O>(m);
      const Tracked<T>& x = from[c].c[m];
      plain[c].c[m] = static_cast<S>(x.value);
      // A mixed derivative stands for two entries of the Hessian.
      const double weight = order == 2 && factor == 1 ? 2 : factor * factor;
      if constexpr (is_multiprecision<T>) {
        size[order] += weight * squared(x.value);
        Sum bound;
        mpfr_set_ld(bound.data(), x.error, MPFR_RNDU);
        error[order] += weight * squared(bound);
      } else {
        size[order] += weight * squared(static_cast<double>(x.value));
        error[order] += weight * squared(x.error);
      }
    }
  BoundedJet<S, F::components> result;
  result.digits = digits_of<T>;
  result.jet = finish<F, O, S>(plain, unit, limit);
  for (int o = 0; o <= O && o < limit; ++o) {
    using std::sqrt;
    result.bound[o] = std::same_as<T, S> ? Bound(0) : static_cast<Bound>(unit_roundoff<S>());
    if (error[o] != Sum(0))
      result.bound[o] += static_cast<Bound>(roundoff_of<T>() * static_cast<ErrorOf<T>>(Sum(sqrt(error[o] / size[o]))));
    if (!(result.bound[o] < 1)) result.bound[o] = 1;
  }
  return result;
}

/// The same in double, rounded.
template <int C>
BoundedJet<double, C> rounded(const BoundedJet<Mp200, C>& wide) {
  BoundedJet<double, C> result{narrowed<double>(wide.jet)};
  result.digits = wide.digits;
  for (int o = 0; o < 3; ++o)
    if (wide.bound[o] > 0) result.bound[o] = std::min(1., static_cast<double>(wide.bound[o]) + 0x1p-53);
  return result;
}

/// A formula's parameters as tracked numbers, rounded where T has fewer digits.
template <class F, class T, Scalar S>
std::array<Tracked<T>, F::parameter_count> tracked_parameters(std::span<const S> parameters) {
  std::array<Tracked<T>, F::parameter_count> tracked;
  for (int i = 0; i < F::parameter_count; ++i) {
    ErrorOf<T> error = 0;
    if constexpr (is_multiprecision<S>) error = size_of(T(parameters[i]));
    tracked[i] = Tracked<T>(T(parameters[i]), error);
  }
  return tracked;
}

}  // namespace cageproof::closed_form::triangle
