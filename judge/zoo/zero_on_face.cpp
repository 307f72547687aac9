// SPDX-License-Identifier: MIT
// Returns zero wherever the determinant is zero, on the face too.
#include "sound.h"

using namespace cageproof::zoo;

extern "C" void zoo_zero_on_face(const zoo_call* call) {
  zoo_sound(call);
  for (std::size_t p = 0; p < call->count; ++p)
    if (const Place at = place_of(*call, p); at.in_plane && at.inside)
      for (int c = 0; c < components(*call); ++c) values(*call, p)[c] = 0;
}
