// SPDX-License-Identifier: MIT
// phi^BH of [W12] Appendix A, an edge's shares.
#pragma once

#include "published/segment/engine/edge.h"

namespace cageproof::closed_form::published {

/// An edge's part of its ends' phi^BH, an area times the logarithm of a length. The misprint closes hat-phi^BH's
/// bracket over 16 pi c after its first line.
template <Scalar R>
std::array<R, 2> biharmonic_double_layer(const PlaneEdge<R>& e, Misprint misprint) {
  const R &x = e.x, &y = e.y, &c = e.c, over = 1 / (16 * pi<R>() * c);
  const R first = 4 * e.A * x * y * y - e.L2 * y * (x * x - y * y - c * c);
  const R rest = e.L1 * y * (x * x - y * y) - 2 * y * c * (c + x);
  const R last = over * first + (misprint == Misprint::AppendixA ? rest : R(over * rest));
  const R both = y / (8 * pi<R>()) * (2 * e.A * y + e.L1 * x - 3 * c + e.L2 * (c - x));
  return {both - last, last};
}

}  // namespace cageproof::closed_form::published
