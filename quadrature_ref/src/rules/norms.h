// SPDX-License-Identifier: MIT
// Sizes of tensors.
#pragma once

#include "cageproof/core/numbers/scalar.h"

#include <cmath>
#include <limits>
#include <vector>

namespace cageproof::quadrature_ref {

/// Square root of the sum of squares, also where these leave the range of numbers.
template <Scalar W>
W norm(const std::vector<W>& tensor) {
  using std::sqrt;
  W square = 0;
  for (const W& entry : tensor) square += entry * entry;
  if constexpr (!is_multiprecision<W>) {
    if (!(square > std::numeric_limits<W>::min() * 4096 && square < std::numeric_limits<W>::max())) {
      W length = 0;
      for (const W& entry : tensor) length = std::hypot(length, entry);
      return length;
    }
  }
  return sqrt(square);
}

/// |a - b| / |b|; infinite where nothing can be said.
template <Scalar W>
double relative_difference(const std::vector<W>& a, const std::vector<W>& b) {
  std::vector<W> difference(a.size());
  for (std::size_t i = 0; i < a.size(); ++i) difference[i] = a[i] - b[i];
  const double ratio = static_cast<double>(W(norm(difference) / norm(b)));
  return std::isfinite(ratio) ? ratio : std::numeric_limits<double>::infinity();
}

}  // namespace cageproof::quadrature_ref
