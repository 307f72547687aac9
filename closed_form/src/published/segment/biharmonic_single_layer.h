// SPDX-License-Identifier: MIT
// psi^BH of [W12] Appendix A.
#pragma once

#include "published/segment/engine/edge.h"

namespace cageproof::closed_form::published {

/// psi_i^BH, a volume times the logarithm of a length.
template <Scalar R>
std::array<R, 1> biharmonic_single_layer(const PlaneEdge<R>& e, Misprint) {
  const R &x = e.x, &y = e.y, &c = e.c;
  return {-(3 * e.L1 * x * (3 * y * y + x * x) + 3 * e.L2 * (c - x) * (c * c - 2 * c * x + 3 * y * y + x * x) +
            12 * e.A * y * y * y + 24 * (c * c * x - c * x * x) - 8 * c * c * c - 30 * c * y * y) /
          (144 * pi<R>())};
}

}  // namespace cageproof::closed_form::published
