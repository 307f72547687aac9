// SPDX-License-Identifier: MIT
// The share of a result that the spacing of subnormal numbers takes.
#pragma once

#include "cageproof/closed_form/arithmetic/jet.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace cageproof::closed_form {

/// At most this share of an order's norm is lost by rounding entries to multiples of the least positive number: the
/// largest of orders 0 to `order`. Nothing where all entries are normal numbers or zero.
template <class R, int C, int D>
double share_of_spacing(const Jet<R, C, D>& jet, int order) {
  double largest = 0;
  double norm = 0;
  int subnormal = 0;
  const auto see = [&](R entry) {
    if (!std::isfinite(entry)) return;
    norm = std::hypot(norm, static_cast<double>(entry));
    subnormal += std::fpclassify(entry) == FP_SUBNORMAL;
  };
  const auto end_order = [&] {
    if (subnormal > 0)
      largest =
          std::max(largest, std::sqrt(subnormal) * static_cast<double>(std::numeric_limits<R>::denorm_min()) / norm);
    norm = 0;
    subnormal = 0;
  };
  std::ranges::for_each(jet.value, see);
  end_order();
  for (int c = 0; order > 0 && c < C; ++c)
    for (int i = 0; i < D; ++i) see(jet.gradient[c][i]);
  end_order();
  for (int c = 0; order > 1 && c < C; ++c)
    for (int i = 0; i < D; ++i)
      for (int j = 0; j < D; ++j) see(jet.hessian[c](i, j));
  end_order();
  return largest;
}

}  // namespace cageproof::closed_form
