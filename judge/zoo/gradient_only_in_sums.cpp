// SPDX-License-Identifier: MIT
// A gradient with terms of each edge that cancel between neighbours: right only in closed cages.
#include "sound.h"

using namespace cageproof::zoo;

extern "C" void zoo_gradient_only_in_sums(const zoo_call* call) {
  zoo_sound(call);
  for (std::size_t p = 0; p < call->count; ++p)
    for (int k = 0; k < 3 && call->order > 0; ++k) {
      const Point from = corner(*call, k), to = corner(*call, (k + 1) % 3), edge = to - from;
      const Point middle = point(*call, p) - 0.5 * (from + to);
      for (int i = 0; i < 3; ++i) gradients(*call, p)[i] += edge[static_cast<std::size_t>(i)] / dot(middle, middle);
    }
}
