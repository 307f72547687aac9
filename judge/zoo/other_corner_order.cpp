// SPDX-License-Identifier: MIT
// Sound: begins with the second corner.
#include "sound.h"

#include <algorithm>

using namespace cageproof::zoo;

extern "C" void zoo_other_corner_order(const zoo_call* call) {
  zoo_sound(call);
  for (std::size_t p = 0; p < call->count; ++p) {
    double* const w = values(*call, p);
    std::rotate(w, w + 1, w + 3);
    if (double* const g = gradients(*call, p)) std::rotate(g, g + 3, g + 9);
  }
}
