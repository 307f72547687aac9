// SPDX-License-Identifier: MIT
// Each corner's value is wrong by what its neighbours' are wrong by, so that their sum is right.
#include "sound.h"

using namespace cageproof::zoo;

extern "C" void zoo_sum_made_right(const zoo_call* call) {
  zoo_sound(call);
  for (std::size_t p = 0; p < call->count; ++p) {
    double* const w = values(*call, p);
    const double shift = 0.1 * (w[0] + w[1] + w[2]) * point(*call, p)[0];
    w[0] += shift;
    w[1] -= shift;
  }
}
