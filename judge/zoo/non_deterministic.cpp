// SPDX-License-Identifier: MIT
// Sums in an order that changes from call to call, of numbers that cancel.
#include "sound.h"

#include <cstdint>

using namespace cageproof::zoo;

extern "C" void zoo_non_deterministic(const zoo_call* call) {
  static std::uint64_t state = 1;
  zoo_sound(call);
  for (std::size_t p = 0; p < call->count; ++p) {
    state = state * 6364136223846793005U + 1442695040888963407U;
    for (int c = 0; c < components(*call); ++c) values(*call, p)[c] *= 1 + 1e-9 * static_cast<double>(state >> 60U);
  }
}
