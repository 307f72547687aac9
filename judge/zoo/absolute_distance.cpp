// SPDX-License-Identifier: MIT
// Points nearer than 1e-6 to a corner are the corner, whatever the unit of length is.
#include "sound.h"

using namespace cageproof::zoo;

extern "C" void zoo_absolute_distance(const zoo_call* call) {
  zoo_sound(call);
  for (std::size_t p = 0; p < call->count; ++p)
    for (int k = 0; k < corners(*call); ++k) {
      const double distance = norm(point(*call, p) - corner(*call, k));
      if (distance > 0 && distance < 1e-6) for_each_number(*call, p, [](double& x) { x = 0; });
    }
}
