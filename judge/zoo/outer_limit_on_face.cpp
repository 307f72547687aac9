// SPDX-License-Identifier: MIT
// On the face the limit from outside, where the one from inside is meant.
#include "sound.h"

using namespace cageproof::zoo;

extern "C" void zoo_outer_limit_on_face(const zoo_call* call) {
  zoo_sound(call);
  for (std::size_t p = 0; p < call->count; ++p)
    if (const Place at = place_of(*call, p); at.in_plane && at.inside) values(*call, p)[0] = -2 * std::acos(-1.0);
}
