// SPDX-License-Identifier: MIT
// Takes the solid angle for half of all directions wherever the determinant is zero.
#include "sound.h"

using namespace cageproof::zoo;

extern "C" void zoo_plane_branch(const zoo_call* call) {
  zoo_sound(call);
  for (std::size_t p = 0; p < call->count; ++p)
    if (const Place at = place_of(*call, p); at.in_plane && !at.inside && !at.on_border)
      values(*call, p)[0] = 2 * std::acos(-1.0);
}
