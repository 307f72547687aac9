// SPDX-License-Identifier: MIT
// Sound: the solid angle over -4 pi.
#include "sound.h"

using namespace cageproof::zoo;

extern "C" void zoo_minus_over_four_pi(const zoo_call* call) {
  zoo_sound(call);
  for (std::size_t p = 0; p < call->count; ++p)
    for_each_number(*call, p, [](double& x) { x *= -1 / (4 * std::acos(-1.0)); });
}
