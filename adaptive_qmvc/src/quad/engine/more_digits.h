// SPDX-License-Identifier: MIT
// Line forms in wider scalars: in the narrowest that holds the digits asked for, and to as many digits more as cancel.
#pragma once

#include "cageproof/closed_form/arithmetic/climb.h"
#include "cageproof/core/catalogue/batch.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace cageproof::adaptive_qmvc {

/// An attempt's statement, and how many times as large as the result its terms are, roughly.
struct Cancelled {
  Statement statement;
  double times = 1;
};

/// Asks for `digits`, and where terms are more than `allowed` times as large as their sum for as many more as that
/// costs, up to `most`. \param times how many times as large they are known to be
/// \param attempt called with the digits, returns Cancelled
template <class Attempt>
Statement with_what_cancels(double digits, double most, double allowed, double times, const Attempt& attempt) {
  for (double asked = digits;;) {
    if (times > allowed) asked = std::min(most, std::max(asked, digits + 1 + std::log10(times)));
    const Cancelled found = attempt(asked);
    times = found.times;
    if (asked >= most || times <= allowed || asked >= digits + std::log10(times)) return found.statement;
  }
}

/// In the first scalar of the ladder that takes the attempt, or in the last one.
/// \param attempt called as attempt.template operator()<W>(); nothing where W does not do
template <class... W, class Attempt>
auto in_first_of(const Attempt& attempt) {
  const auto found =
      closed_form::climb(closed_form::Ladder<W...>(), attempt, [](const auto& result) { return result.has_value(); });
  return *found;
}

}  // namespace cageproof::adaptive_qmvc
