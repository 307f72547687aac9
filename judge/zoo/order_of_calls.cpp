// SPDX-License-Identifier: MIT
// Starts each point from the one before, and does not quite arrive.
#include "sound.h"

using namespace cageproof::zoo;

extern "C" void zoo_order_of_calls(const zoo_call* call) {
  static Point before{};
  zoo_sound(call);
  for (std::size_t p = 0; p < call->count; ++p) {
    for (int c = 0; c < components(*call); ++c)
      values(*call, p)[c] *= 1 + 1e-5 * std::sin(before[0] - point(*call, p)[0]);
    before = point(*call, p);
  }
}
