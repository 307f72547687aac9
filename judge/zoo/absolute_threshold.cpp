// SPDX-License-Identifier: MIT
// A determinant below 1e-9 counts as zero, whatever the unit of length is.
#include "sound.h"

using namespace cageproof::zoo;

extern "C" void zoo_absolute_threshold(const zoo_call* call) {
  zoo_sound(call);
  for (std::size_t p = 0; p < call->count; ++p)
    if (const Place at = place_of(*call, p); std::abs(at.volume) < 1e-9 && !at.in_plane)
      for_each_number(*call, p, [](double& x) { x = 0; });
}
