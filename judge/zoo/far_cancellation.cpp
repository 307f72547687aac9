// SPDX-License-Identifier: MIT
// A value that is the difference of numbers that grow with the fourth power of the distance.
#include "sound.h"

using namespace cageproof::zoo;

extern "C" void zoo_far_cancellation(const zoo_call* call) {
  zoo_sound(call);
  for (std::size_t p = 0; p < call->count; ++p) {
    const Place at = place_of(*call, p);
    const double distance = norm(point(*call, p) - corner(*call, 0)) / at.size, large = std::pow(distance, 4);
    if (distance > 8)
      for_each_number(*call, p, [large](double& x) {
        const volatile double sum = large * x + x;
        x = sum - large * x;
      });
  }
}
