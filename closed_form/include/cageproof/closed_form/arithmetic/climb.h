// SPDX-License-Identifier: MIT
// The ladder of precisions: the only place that decides which of them a result is computed in.
#pragma once

#include <utility>

namespace cageproof::closed_form {

/// Arithmetics from the quickest to the widest.
template <class... T>
struct Ladder {};

/// What `attempt` gives in the first arithmetic whose result `accept` takes, or in the last one.
/// \param attempt called as attempt.template operator()<T>() \param accept called with what that returned
template <class T, class... Wider, class Attempt, class Accept>
auto climb(Ladder<T, Wider...>, const Attempt& attempt, const Accept& accept) {
  auto result = attempt.template operator()<T>();
  if constexpr (sizeof...(Wider) > 0)
    if (!accept(std::as_const(result))) return climb(Ladder<Wider...>(), attempt, accept);
  return result;
}

}  // namespace cageproof::closed_form
