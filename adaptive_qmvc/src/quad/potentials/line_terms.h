// SPDX-License-Identifier: MIT
// Sums of products along lines, before they are numbered: what tapes are made of.
#pragma once

#include "quad/potentials/kernel_terms.h"

#include <algorithm>
#include <array>
#include <compare>
#include <cstdint>
#include <map>
#include <vector>

namespace cageproof::adaptive_qmvc {

/// An integrand x^power (other factors) (basis) / r^(2m + 1).
struct LineTerm {
  int m = 0;
  std::array<std::int8_t, 3> power{0, 0, 0};  ///< of each component of x
  std::array<int, 3> others{-1, -1, -1};      ///< further factors in rising order, after -1 for none
  BasisPart basis = BasisPart::Phi;
  bool around = false;   ///< integrated around the border
  bool divided = false;  ///< by the length of the normal at the lines' point

  auto operator<=>(const LineTerm&) const = default;

  LineTerm times_x(int i) const {
    LineTerm term = *this;
    ++term.power[i];
    return term;
  }
  /// \pre at most two other factors
  LineTerm times(int factor) const {
    LineTerm term = *this;
    term.others[0] = factor;
    std::ranges::sort(term.others);
    return term;
  }
};

/// Coefficients of the two parameters.
using Factors = std::array<double, 2>;
using LineTerms = std::map<LineTerm, Factors>;

inline void add_to(LineTerms& terms, const LineTerm& term, const Factors& factors, double times) {
  Factors& to = terms[term];
  for (int p = 0; p < 2; ++p) to[p] += times * factors[p];
}

/// A tape's entries for each order, the index of derivatives the fastest.
using TapeEntries = std::array<std::vector<LineTerms>, 3>;

/// The kernel's entries with its derivatives by eta up to an order.
TapeEntries plain_entries(Potential potential, int order);

/// Replaces the entries whose kernels cancel next to the quad. False where there are none.
bool make_tangential(Potential potential, int order, TapeEntries& entries);

}  // namespace cageproof::adaptive_qmvc
