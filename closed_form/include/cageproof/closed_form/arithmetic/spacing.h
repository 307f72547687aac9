// SPDX-License-Identifier: MIT
// The share of a result that the spacing of subnormal numbers takes.
#pragma once

#include "cageproof/closed_form/arithmetic/jet.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace cageproof::closed_form {

/// A bound of the share of an order's norm that is lost by rounding entries to multiples of the least positive number;
/// the largest of orders 0 to `order`. It is 0 where all entries are normal numbers or zero, and 1 where all that is
/// left of an order is zeros that are not exact. \param bound of each order's error; zero where its numbers are exact
template <class R, int C, int D, class Bound>
double share_of_spacing(const Jet<R, C, D>& jet, const std::array<Bound, 3>& bound, int order) {
  double largest = 0;
  double norm = 0;
  int subnormal = 0, seen = 0;
  const auto see = [&](R entry) {
    if (!std::isfinite(entry)) return;
    ++seen;
    norm = std::hypot(norm, static_cast<double>(entry));
    subnormal += std::fpclassify(entry) == FP_SUBNORMAL;
  };
  const auto end_order = [&](int o) {
    if (o <= order && seen > 0 && norm == 0 && bound[static_cast<std::size_t>(o)] > 0) largest = 1;
    if (subnormal > 0)
      largest =
          std::max(largest, std::sqrt(subnormal) * static_cast<double>(std::numeric_limits<R>::denorm_min()) / norm);
    norm = 0;
    subnormal = seen = 0;
  };
  std::ranges::for_each(jet.value, see);
  end_order(0);
  for (int c = 0; order > 0 && c < C; ++c)
    for (int i = 0; i < D; ++i) see(jet.gradient[c][i]);
  end_order(1);
  for (int c = 0; order > 1 && c < C; ++c)
    for (int i = 0; i < D; ++i)
      for (int j = 0; j < D; ++j) see(jet.hessian[c](i, j));
  end_order(2);
  return largest;
}

}  // namespace cageproof::closed_form
