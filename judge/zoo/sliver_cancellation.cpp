// SPDX-License-Identifier: MIT
// Terms of size one over the third power of the aspect, which cancel.
#include "sound.h"

using namespace cageproof::zoo;

extern "C" void zoo_sliver_cancellation(const zoo_call* call) {
  zoo_sound(call);
  for (std::size_t p = 0; p < call->count; ++p) {
    const Place at = place_of(*call, p);
    const double large = std::pow(at.size * at.size / at.area, 3);
    if (large > 300)
      for_each_number(*call, p, [large](double& x) {
        const volatile double sum = large * x + x;
        x = sum - large * x;
      });
  }
}
