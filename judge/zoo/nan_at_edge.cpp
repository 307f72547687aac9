// SPDX-License-Identifier: MIT
// Divides by the distance from an edge, which is zero on it.
#include "sound.h"

using namespace cageproof::zoo;

extern "C" void zoo_nan_at_edge(const zoo_call* call) {
  zoo_sound(call);
  for (std::size_t p = 0; p < call->count; ++p) {
    const Place at = place_of(*call, p);
    if (at.on_border && !is_corner(*call, p)) for_each_number(*call, p, [](double& x) { x = std::nan(""); });
  }
}
