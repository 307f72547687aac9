// SPDX-License-Identifier: MIT
// The promises of the adaptive rules of flat elements.
#pragma once

#include "cageproof/core/numbers/scalar.h"

#include <cstddef>

namespace cageproof::quadrature_ref {

/// The relative tolerance of integrate_adaptive, norm-wise for each derivative order.
template <Scalar R>
double adaptive_tolerance() {
  return std::same_as<R, float> ? 1e-4 : std::same_as<R, double> ? 1e-10 : 1e-15;
}
/// integrate_adaptive gives up before it spends more kernel evaluations than this.
inline constexpr std::size_t kAdaptiveNodeLimit = 200'000;

}  // namespace cageproof::quadrature_ref
