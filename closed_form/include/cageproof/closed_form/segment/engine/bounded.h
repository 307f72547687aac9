// SPDX-License-Identifier: MIT
// A closed form's results in the plane with a bound of their error, from numbers that carry one along.
#pragma once

#include "cageproof/closed_form/arithmetic/bounded_jet.h"
#include "cageproof/closed_form/segment/engine/scalar.h"

namespace cageproof::closed_form::segment {

/// Calls `visit` with each entry of an order of a jet.
template <class R, int C, class Visit>
void for_each_entry(int order, const Jet<R, C, 2>& jet, Visit&& visit) {
  for (int c = 0; c < C; ++c) {
    if (order == 0) visit(jet.value[c]);
    for (int i = 0; i < 2; ++i) {
      if (order == 1) visit(jet.gradient[c][i]);
      for (int j = 0; order == 2 && j < 2; ++j) visit(jet.hessian[c](i, j));
    }
  }
}

/// Whether a finite number is beyond `largest`, for results in double or float.
template <cageproof::Scalar S, class T>
bool is_beyond(const Tracked<T>& x, double largest) {
  using std::isfinite;
  if constexpr (is_multiprecision<S>) return false;
  else return isfinite(x.value) && std::abs(static_cast<double>(x.value)) > largest;
}

/// A tracked jet up to order O, rounded to S, with its bound. Entries beyond `largest` become infinities and are not in
/// the norm, so that the others keep digits of their own.
template <int O, cageproof::Scalar S, class T, int C>
BoundedJet<S, C, 2> bounded(const Jet<Tracked<T>, C, 2>& from, double largest) {
  using Bound = ErrorOf<S>;
  // Squares of multiprecision numbers may leave double's range.
  using Sum = std::conditional_t<is_multiprecision<T>, T, double>;
  BoundedJet<S, C, 2> result;
  result.digits = digits_of<T>;
  for (int c = 0; c < C; ++c) {
    result.jet.value[c] = static_cast<S>(from.value[c].value);
    for (int i = 0; i < 2; ++i) {
      result.jet.gradient[c][i] = static_cast<S>(from.gradient[c][i].value);
      for (int j = 0; j < 2; ++j) result.jet.hessian[c](i, j) = static_cast<S>(from.hessian[c](i, j).value);
    }
  }
  for (int o = 0; o <= O; ++o) {
    Sum size = 0, error = 0;
    bool overflows = false;
    for_each_entry(o, from, [&](const Tracked<T>& x) {
      if (is_beyond<S>(x, largest)) {
        // An infinity of the right sign, where that is certain.
        overflows = overflows || !(static_cast<ErrorOf<T>>(roundoff_of<T>()) * x.error < size_of(x.value));
        return;
      }
      if constexpr (is_multiprecision<T>) {
        if (!isfinite(x.value)) return;  // a limit
        size += x.value * x.value;
        const Sum bound = x.error;
        error += bound * bound;
      } else {
        overflows = overflows || !std::isfinite(x.value);
        size = std::hypot(size, x.value);
        error = std::hypot(error, x.error);
      }
    });
    using std::sqrt;
    if (error == Sum(0) && !overflows) continue;
    // Errors of norms below the least normal number are relative to that number: zeros beside infinities have no norm.
    if constexpr (!is_multiprecision<S>) {
      const Sum least = is_multiprecision<T> ? Sum(Sum(4 / largest) * Sum(4 / largest)) : Sum(4 / largest);
      size = size < least ? least : size;
    }
    const Sum ratio = is_multiprecision<T> ? Sum(sqrt(Sum(error / size))) : Sum(error / size);
    result.bound[o] = static_cast<Bound>(roundoff_of<T>() * static_cast<ErrorOf<T>>(ratio));
    if (!std::same_as<T, S>) result.bound[o] += static_cast<Bound>(cageproof::unit_roundoff<S>());
    if (overflows || !(result.bound[o] < 1)) result.bound[o] = 1;
  }
  return result;
}

}  // namespace cageproof::closed_form::segment
