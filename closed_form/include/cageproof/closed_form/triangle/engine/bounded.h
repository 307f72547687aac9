// SPDX-License-Identifier: MIT
// A closed form's results with a bound of their error, from numbers that carry one along.
#pragma once

#include "cageproof/closed_form/arithmetic/bounded_jet.h"
#include "cageproof/closed_form/triangle/engine/evaluate.h"

namespace cageproof::closed_form::triangle {

/// The relative error of one order's entries that are at most `largest`; infinite where it has no bound. Larger entries
/// will be rounded to infinities: they are not in the norm, and their signs must be certain. Squares are summed in long
/// double, whose range holds those of T's numbers. \param least the smallest norm that errors are divided by
template <class F, int O, class T>
long double error_within(const Components<F, Tracked<T>, O>& from, int order, long double largest, long double least) {
  using Number = std::conditional_t<is_multiprecision<T>, long double, double>;
  constexpr long double unknown = std::numeric_limits<long double>::infinity();
  long double size = 0, error = 0;
  for (int c = 0; c < F::components; ++c)
    for (int m = 0; m < Monomials<O>::count; ++m) {
      const auto& e = Monomials<O>::exponents[m];
      if (e[0] + e[1] + e[2] != order) continue;
      const Tracked<T>& x = from[c].c[m];
      const int factor = derivative_factor<O>(m), times = order == 2 && factor == 1 ? 2 : 1;
      const long double rounding = roundoff_of<T>() * x.error * factor;
      const long double entry = static_cast<long double>(factor) * std::abs(static_cast<Number>(x.value));
      if (!std::isfinite(entry)) return unknown;
      if (entry > largest) {
        if (!(rounding < entry)) return unknown;
        continue;
      }
      size += times * entry * entry;
      error += times * rounding * rounding;
    }
  return error == 0 ? 0 : std::sqrt(error) / std::max(std::sqrt(size), least);
}

/// The components rounded to S with their error bounds; orders from `limit` on are left out of the bounds.
/// \param largest finite number of the type that results in double are narrowed to, infinite for others
template <class F, int O, Scalar S, class T>
BoundedJet<S, F::components> bounded(const Components<F, Tracked<T>, O>& from, const S& unit, int limit,
                                     double largest) {
  // Squares of multiprecision numbers may leave double's range.
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
        const Sum bound = x.error;
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
    // `end` is `largest` in the components' unit. A norm below `end` has no entry beyond it.
    const int exponent = is_multiprecision<S> ? 0 : (F::degree - o) * std::ilogb(static_cast<double>(unit));
    const double end = std::ldexp(largest, -exponent);
    if (std::isfinite(largest) && !(size[o] < squared(Sum(end)))) {
      // Errors of norms below the least normal number are relative to that number.
      const long double within = error_within<F, O, T>(from, o, end, std::ldexp(4 / largest, -exponent));
      result.bound[o] += static_cast<Bound>(within);
    } else if (error[o] != Sum(0))
      result.bound[o] += static_cast<Bound>(roundoff_of<T>() * static_cast<ErrorOf<T>>(Sum(sqrt(error[o] / size[o]))));
    if (!(result.bound[o] < 1)) result.bound[o] = 1;
  }
  return result;
}

/// The jet rounded to double, with the bound of that.
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
