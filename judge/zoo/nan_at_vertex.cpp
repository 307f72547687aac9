// SPDX-License-Identifier: MIT
// Divides by the distance from a corner, which is zero there.
#include "sound.h"

using namespace cageproof::zoo;

extern "C" void zoo_nan_at_vertex(const zoo_call* call) {
  zoo_sound(call);
  for (std::size_t p = 0; p < call->count; ++p)
    if (is_corner(*call, p)) for_each_number(*call, p, [](double& x) { x = std::nan(""); });
}
