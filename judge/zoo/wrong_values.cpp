// SPDX-License-Identifier: MIT
// Wrong above one half of the element, by no known cause.
#include "sound.h"

using namespace cageproof::zoo;

extern "C" void zoo_wrong_values(const zoo_call* call) {
  zoo_sound(call);
  for (std::size_t p = 0; p < call->count; ++p)
    if (const Place at = place_of(*call, p); at.hat[0] > 0.6) for_each_number(*call, p, [](double& x) { x *= 1.25; });
}
