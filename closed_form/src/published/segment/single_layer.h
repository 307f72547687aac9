// SPDX-License-Identifier: MIT
// psi^H of [W12] Appendix A.
#pragma once

#include "published/segment/engine/edge.h"

namespace cageproof::closed_form::published {

/// psi_i^H = -(2 A y + L1 x - 2 c + (c - x) L2)/(4 pi): a length times the logarithm of one.
template <Scalar R>
std::array<R, 1> single_layer(const PlaneEdge<R>& e, Misprint) {
  return {-(2 * e.A * e.y + e.L1 * e.x - 2 * e.c + (e.c - e.x) * e.L2) / (4 * pi<R>())};
}

}  // namespace cageproof::closed_form::published
