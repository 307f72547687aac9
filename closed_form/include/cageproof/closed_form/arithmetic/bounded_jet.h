// SPDX-License-Identifier: MIT
// A jet with a bound of its error, and what closed forms take as good enough.
#pragma once

#include "cageproof/closed_form/arithmetic/jet.h"
#include "cageproof/closed_form/arithmetic/tracked.h"

#include <algorithm>

namespace cageproof::closed_form {

/// Limits for a result's own relative error bound. `accurate` takes 128 units, half of its promise, because running
/// bounds are themselves rounded. `closed_form` takes 1000, more than the 64 conditioned units of its promise, because
/// running bounds exceed its errors tenfold and more.
inline constexpr double kAccurateTolerance = 128 * 0x1p-53, kTolerance = 1000 * 0x1p-53;

/// A jet, and a bound of each order's relative error, norm-wise over those entries that are finite and within the
/// result's range; zero where all of these are exact, and for orders without a limit.
template <Scalar S, int C, int D = 3>
struct BoundedJet {
  using Bound = ErrorOf<S>;

  Jet<S, C, D> jet;
  std::array<Bound, 3> bound{0, 0, 0};
  int digits = 0;  ///< decimal ones of the arithmetic that computed it; 0: none did, the jet is a limit

  Bound worst() const { return std::max({bound[0], bound[1], bound[2]}); }
};

/// BoundedJet::digits of an arithmetic.
template <class T>
inline constexpr int digits_of = std::numeric_limits<T>::digits10;
template <>
inline constexpr int digits_of<DoubleDouble> = 30;

}  // namespace cageproof::closed_form
