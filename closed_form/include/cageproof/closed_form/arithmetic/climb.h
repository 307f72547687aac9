// SPDX-License-Identifier: MIT
// The ladder of precisions: tries one arithmetic after the other until a result is accepted.
#pragma once

#include <utility>

namespace cageproof::closed_form {

/// Arithmetics from the quickest to the widest.
template <class... T>
struct Ladder {};

/// Returns the result of `attempt` in the first arithmetic for which `accept` is true, or in the last one.
/// \param attempt called as attempt.template operator()<T>() \param accept called with what that returned
template <class T, class... Wider, class Attempt, class Accept>
auto climb(Ladder<T, Wider...>, const Attempt& attempt, const Accept& accept) {
  auto result = attempt.template operator()<T>();
  if constexpr (sizeof...(Wider) > 0)
    if (!accept(std::as_const(result))) return climb(Ladder<Wider...>(), attempt, accept);
  return result;
}

}  // namespace cageproof::closed_form
