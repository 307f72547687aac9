// SPDX-License-Identifier: MIT
// Divides by the height over the plane, which is zero on the face.
#include "sound.h"

using namespace cageproof::zoo;

extern "C" void zoo_nan_at_face(const zoo_call* call) {
  zoo_sound(call);
  for (std::size_t p = 0; p < call->count; ++p) {
    const Place at = place_of(*call, p);
    if (at.in_plane && at.inside) for_each_number(*call, p, [](double& x) { x = std::nan(""); });
  }
}
