// SPDX-License-Identifier: MIT
// phi^H of [W12] Appendix A, an edge's shares.
#pragma once

#include "published/segment/engine/edge.h"

namespace cageproof::closed_form::published {

/// An edge's part of its ends' phi^H: A/(2 pi) - hat-phi^H and hat-phi^H, unitless.
template <Scalar R>
std::array<R, 2> double_layer(const PlaneEdge<R>& e, Misprint) {
  const R last = (2 * e.x * e.A - e.y * (e.L1 - e.L2)) / (4 * pi<R>() * e.c);
  return {e.A / (2 * pi<R>()) - last, last};
}

}  // namespace cageproof::closed_form::published
