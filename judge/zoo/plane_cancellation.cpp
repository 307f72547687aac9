// SPDX-License-Identifier: MIT
// A difference of numbers that grow with one over the squared height.
#include "sound.h"

using namespace cageproof::zoo;

extern "C" void zoo_plane_cancellation(const zoo_call* call) {
  zoo_sound(call);
  for (std::size_t p = 0; p < call->count; ++p) {
    const Place at = place_of(*call, p);
    const double height = std::abs(at.height) / at.size;
    if (height > 0.05 || at.in_plane || at.inside) continue;
    const double large = 1 / (height * height);
    for_each_number(*call, p, [large](double& x) {
      const volatile double sum = large * x + x;
      x = sum - large * x;
    });
  }
}
