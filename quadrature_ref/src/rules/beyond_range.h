// SPDX-License-Identifier: MIT
// The digits of a tensor some of whose entries leave the range of the result's scalar: a norm of entries of 1e600 says
// nothing about an entry of 1e300.
#pragma once

#include "elementary.h"
#include "norms.h"

#include <algorithm>

namespace cageproof::quadrature_ref {

/// The spread of a tensor's entries: how many digits those within the range have fewer than the whole tensor. None if
/// no entry leaves the range.
struct EntrySpread {
  double within = 0;  ///< log10 of the tensor's norm over the norm of its entries within range
  double beyond = -std::numeric_limits<double>::infinity();  ///< the same over the least entry beyond it

  /// Whether an entry left the range.
  bool leaves_range() const { return beyond > -1; }
  /// The digits of the entries within range if the whole tensor has `digits`; 0 where these leave the sign of an entry
  /// beyond it open.
  double digits_left(double digits) const {
    return digits > beyond + 1 ? digits - within : leaves_range() ? 0 : digits;
  }
  /// The digits of the whole tensor that leave `digits` to the entries within range, and tell the signs.
  double digits_for(double digits) const { return std::max(digits + within, beyond + 2); }
};

/// \param sums in any unit of length \param rounded the same in the result's scalar and unit
template <Scalar R, Scalar W>
EntrySpread entry_spread(const std::vector<W>& sums, const std::vector<R>& rounded) {
  if constexpr (is_multiprecision<R>) {
    return {};
  } else {
    using std::isfinite;
    std::vector<W> within;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < sums.size(); ++i) {
      if (isfinite(sums[i]) && std::isfinite(rounded[i])) within.push_back(sums[i]);
      else if (!is_multiprecision<W> && !isfinite(sums[i])) return {least, least};  // nothing is known of any entry
      else if (isfinite(sums[i]) && sums[i] != 0) least = std::min(least, log10_magnitude(sums[i]));
    }
    if (!(least < std::numeric_limits<double>::infinity())) return {};
    const auto size = [](const std::vector<W>& entries) { return log10_magnitude(W(quadrature_ref::norm(entries))); };
    const double whole = size(sums), rest = size(within);
    return {std::isfinite(rest) ? whole - rest : 0, whole - least};
  }
}

}  // namespace cageproof::quadrature_ref
