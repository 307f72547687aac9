// SPDX-License-Identifier: MIT
// A point on an edge is taken for the nearer of its corners.
#include "sound.h"

using namespace cageproof::zoo;

extern "C" void zoo_vertex_for_edge(const zoo_call* call) {
  zoo_sound(call);
  for (std::size_t p = 0; p < call->count; ++p) {
    const Place at = place_of(*call, p);
    if (!at.on_border || is_corner(*call, p)) continue;
    int nearest = 0;
    for (int k = 1; k < 3; ++k)
      if (at.hat[static_cast<std::size_t>(k)] > at.hat[static_cast<std::size_t>(nearest)]) nearest = k;
    zoo_call moved = *call;
    moved.points = call->corners + std::size_t{3} * static_cast<std::size_t>(nearest);
    moved.count = 1;
    moved.values = values(*call, p);
    moved.gradients = gradients(*call, p);
    zoo_sound(&moved);
  }
}
